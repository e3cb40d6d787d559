using System;
using System.Collections.Generic;
using System.Globalization;

namespace RigidBodyDynamics
{
    /// <summary>
    /// The integration has diverged: after a step a number of a body's state, or the square of a velocity, exceeds double precision.
    /// All bodies of the <see cref="Simulation"/> are in their states before that step; those of a batch, before that step or at the start of the call.
    /// </summary>
    public sealed class StateOverflowException : ArithmeticException
    {
        internal StateOverflowException(BodyPlan plan, long step, Body handle = null, bool isLoaded = false) : base(Guard.OneLine(
            "body \"" + (handle?.Name ?? plan.Body.Name) + "\"" + (handle == null ? string.Empty : " " + handle.Index.ToString(CultureInfo.InvariantCulture)) + ": " + Why(plan, step, isLoaded)))
        {
            Body = handle?.Name ?? plan.Body.Name;
            Handle = handle;
            Number = handle?.Index ?? -1;
            Rule = plan.Rule;
            Step = step;
            Time = plan.Steps.StartOf(step + 1);
            Reason = Why(plan, step, isLoaded);
        }

        /// <summary>Name of the body.</summary>
        public string Body { get; }

        /// <summary>The body itself; null if it diverged before its simulation had it.</summary>
        public Body Handle { get; internal set; }

        /// <summary>
        /// The index of <see cref="Handle"/> in <see cref="Simulation.Bodies"/> where it is stored with others; else −1.
        /// </summary>
        public int Number { get; }

        /// <summary>The integrator by which it moves.</summary>
        public Rule Rule { get; }

        /// <summary>The step, from 0, that leads to no finite state.</summary>
        public long Step { get; }

        /// <summary>The end of that step, s.</summary>
        public double Time { get; }

        /// <summary>The message without the body.</summary>
        public string Reason { get; }

        private static string Why(BodyPlan plan, long step, bool isLoaded) => Guard.OneLine(string.Format(
            CultureInfo.InvariantCulture,
            "{0} has diverged: no finite state at t = {1:R} s, after step {2}{3}",
            plan.Rule.Name, plan.Steps.StartOf(step + 1), step,
            Acting(plan, step, isLoaded)));

        /// <summary>The effects in the step: one of them is probably the cause.</summary>
        private static string Acting(BodyPlan plan, long step, bool isLoaded)
        {
            const int MostNamed = 3;
            List<string> named = new List<string>();
            if (isLoaded)
                named.Add("what was applied for this step");

            foreach (StretchPlan stretch in plan.Stretches)
            {
                for (int i = 0; stretch.First <= step && step < stretch.End && i < stretch.Effects.Count; i++)
                {
                    if (i < MostNamed)
                        named.Add("effects[" + plan.Body.IndexOf(stretch.Effects[i]) + "] (" + stretch.Effects[i].Motion + ")");
                    else if (i == MostNamed)
                        named.Add("others");
                }
            }

            return named.Count == 0 ? string.Empty : ", under " + string.Join(", ", named);
        }
    }
}
