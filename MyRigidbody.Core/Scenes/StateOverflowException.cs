using System;
using System.Collections.Generic;
using System.Globalization;

namespace RigidBodyDynamics
{
    /// <summary>
    /// A rule has run away: after a step a number of a body's state, or the square of a velocity, does not fit double precision.
    /// All bodies of the <see cref="Simulation"/> stand before that step; those of a batch, before that step or where the call began.
    /// </summary>
    public sealed class StateOverflowException : ArithmeticException
    {
        internal StateOverflowException(BodyPlan plan, long step, Body handle = null, bool isLoaded = false) : base(Guard.OneLine(
            "body \"" + plan.Body.Name + "\"" + (handle == null ? string.Empty : " " + handle.Index.ToString(CultureInfo.InvariantCulture)) + ": " + Why(plan, step, isLoaded)))
        {
            Body = plan.Body.Name;
            Handle = handle;
            Number = handle?.Index ?? -1;
            Rule = plan.Rule;
            Step = step;
            Time = plan.Steps.StartOf(step + 1);
            Reason = Why(plan, step, isLoaded);
        }

        /// <summary>Name of the body.</summary>
        public string Body { get; }

        /// <summary>The body itself; null if it had run away before its simulation had it.</summary>
        public Body Handle { get; internal set; }

        /// <summary>
        /// The place of <see cref="Handle"/> in <see cref="Simulation.Bodies"/> where it is one of many that are stored together; else −1.
        /// </summary>
        public int Number { get; }

        /// <summary>The rule by which it moves.</summary>
        public Rule Rule { get; }

        /// <summary>The step, from 0, that does not lead to a state.</summary>
        public long Step { get; }

        /// <summary>The end of that step, s.</summary>
        public double Time { get; }

        /// <summary>The message without the body.</summary>
        public string Reason { get; }

        private static string Why(BodyPlan plan, long step, bool isLoaded) => Guard.OneLine(string.Format(
            CultureInfo.InvariantCulture,
            "{0} has run away: no finite state at t = {1:R} s, after step {2}{3}",
            plan.Rule.Name, plan.Steps.StartOf(step + 1), step,
            Acting(plan, step, isLoaded)));

        /// <summary>What acts in the step: one of them is likely to be to blame.</summary>
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
