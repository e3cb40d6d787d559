using System;
using System.Collections.Generic;
using System.Globalization;
using System.Text;

namespace RigidBodyDynamics
{
    /// <summary>
    /// A plan in words: the parts of a body's motion, what was left out and why. Made from the plan that runs, so that the two
    /// cannot differ.
    /// </summary>
    public sealed class Explanation
    {
        private readonly BodyPlan _plan;
        private readonly List<Omission> _leftOut = new List<Omission>();
        private readonly List<string> _notes = new List<string>();

        /// <summary>Explains a body as it moves now.</summary>
        public Explanation(Body body) : this(Guard.NotNull(body, nameof(body)).Plan) { }

        internal Explanation(BodyPlan plan)
        {
            _plan = plan;
            LeaveOut();
            LookAtSwings();
        }

        /// <summary>The parts that are not computed, each with the reason, in brackets, why the motion is the same without it.</summary>
        public IReadOnlyList<string> LeftOut => _leftOut.ConvertAll(omission => omission.ToString());

        internal IReadOnlyList<Omission> Omitted => _leftOut;

        /// <summary>Remarks on the result.</summary>
        public IReadOnlyList<string> Notes => _notes;

        /// <summary>The parts of the motion in a stretch of time.</summary>
        internal IReadOnlyList<string> Parts(StretchPlan stretch)
        {
            List<string> parts = new List<string>();
            BodyDescription body = _plan.Body;
            bool isExact = (_plan.Rule.Keeps & Keeps.Energy) != 0;
            if (body.CanMove)
                parts.Add((body.Lock & Locks.Move) == 0 ? "drift" : "drift along " + (~body.Lock).MoveNames());

            foreach (ICoast coast in stretch.Coasts)
                parts.Add(coast + (isExact && (coast.Traits & EffectTraits.OncePerStep) == 0 ? " (closed form)" : string.Empty));

            if (body.CanTurn)
                parts.Add((body.Lock & Locks.Turn) == 0 ? _plan.Rule.Rotation(body) : "rotation about " + (~body.Lock).TurnNames() + (isExact ? " (exact)" : string.Empty));

            if (_plan.Rule.Settings(body) is string settings)
                parts.Add(settings);

            foreach (PushEffect push in stretch.Pushes)
                parts.Add(push.Push.ToString());

            foreach (Effect effect in stretch.Effects)
            {
                if (effect.Motion is MassRate rate)
                    parts.Add(rate.ToString());
            }

            foreach (ImpulseEffect impulse in stretch.Impulses)
                parts.Add(impulse.Impulse + ", at once");

            if (parts.Count == 0)
                parts.Add("rest");

            return parts;
        }

        /// <summary>True if the steps of a stretch are not taken until the state is read.</summary>
        internal bool Coasts(StretchPlan stretch) => _plan.MayCoast && _plan.Rule.Coasts(_plan.Body, stretch);

        internal string Time(StretchPlan stretch)
        {
            string from = stretch.Starts.ToString("R", CultureInfo.InvariantCulture) + " s";
            if (double.IsPositiveInfinity(stretch.Ends))
                return stretch.First == 0 ? "always" : "from " + from;

            return from + " to " + stretch.Ends.ToString("R", CultureInfo.InvariantCulture) + " s";
        }

        /// <summary>The whole explanation, line by line.</summary>
        public override string ToString()
        {
            const int MostStretches = 20;
            StringBuilder text = new StringBuilder();
            text.Append(_plan.Body.Name).Append(", by ").Append(_plan.Rule.Name).Append('\n');
            for (int i = 0; i < Math.Min(MostStretches, _plan.Stretches.Count); i++)
            {
                StretchPlan stretch = _plan.Stretches[i];
                text.Append("  ").Append(Time(stretch)).Append(": ").Append(string.Join(", ", Parts(stretch)));
                text.Append(Coasts(stretch) ? "; computed when its state is read\n" : "\n");
            }

            if (_plan.Stretches.Count > MostStretches)
                text.Append("  and ").Append(_plan.Stretches.Count - MostStretches).Append(" stretches more\n");

            foreach (Omission omission in _leftOut)
                text.Append("  left out: ").Append(omission).Append('\n');

            foreach (string note in _notes)
                text.Append("  note: ").Append(note).Append('\n');

            return text.ToString();
        }

        private void LeaveOut()
        {
            BodyDescription asked = _plan.Asked;
            const Omissions Steps = Omissions.All & ~Omissions.Coasting;
            foreach (StretchPlan stretch in _plan.Stretches)
            {
                if (Coasts(stretch))
                {
                    Add("steps whose states are not read", "closed form: " + Time(stretch), asked, Steps);
                    break;
                }
            }

            if ((_plan.LeftOut & Omissions.Rotation) != 0)
                Add("rotation", "it starts without angular velocity and no torque acts", asked, Steps & ~Omissions.Rotation);
            else if (!asked.CanTurn)
                Add("rotation", "the scene says that it cannot turn", null, Steps);
            else if ((asked.Lock & Locks.Turn) != 0)
                Add("rotation about " + asked.Lock.TurnNames(), "locked", null, Steps);
            else if (_plan.Rule.Simpler(_plan.Body) is string simpler)
                Add("the general free rotation", simpler, ThreeMoments(asked), Steps);

            if ((_plan.LeftOut & Omissions.Translation) != 0)
                Add("translation", "it starts at rest and nothing moves it", asked, Steps & ~Omissions.Translation);
            else if (!asked.CanMove)
                Add("translation", "the scene says that it cannot move", null, Steps);
            else if ((asked.Lock & Locks.Move) != 0)
                Add("motion along " + asked.Lock.MoveNames(), "locked", null, Steps);

            EffectTraits acting = EffectTraits.None, pushing = EffectTraits.None;
            foreach (Effect effect in asked.Effects)
            {
                acting |= effect.Motion.Traits;
                pushing |= effect.Motion is IPush ? effect.Motion.Traits : EffectTraits.None;
            }

            const string None = "none in the scene";
            if ((acting & EffectTraits.IsGravity) == 0 && asked.CanMove)
                Add("gravity", None, Copy(asked).With(new Gravity(new Vector3d(0, -9.81, 0))), Steps);

            if ((acting & EffectTraits.IsDamping) == 0)
                Add("damping", None, Copy(asked).With(new LinearDamping(0.1)).With(new AngularDamping(0.1)), Steps);

            if ((acting & EffectTraits.IsDrag) == 0 && asked.CanMove)
                Add("drag", None, Copy(asked).With(new QuadraticDrag(0.01)), Steps);

            if ((pushing & (EffectTraits.Moves | EffectTraits.Turns)) == 0)
                Add("forces and torques", None, Copy(asked).With(new Force(new Vector3d(1, 0, 0))).With(Torque.Constant(new Vector3d(1, 0, 0))), Steps);
        }

        private void LookAtSwings()
        {
            double longest = 0;
            for (int i = 0; i < _plan.Stretches.Count; i++)
                longest = Math.Max(longest, _plan.Steps.Length(Math.Min(_plan.Stretches[i].First, _plan.Steps.Count - 1)));

            foreach (Effect effect in _plan.Asked.Effects)
            {
                if (!(effect.Motion is ISwing swing))
                    continue;

                double stable = swing.LongestStableStep(_plan.Asked.Mass);
                _notes.Add(string.Format(
                    CultureInfo.InvariantCulture,
                    "{0}: swings are stable in steps below {1:g3} s{2}",
                    swing,
                    stable,
                    longest < stable ? string.Empty : ", and the scene's is " + longest.ToString("g3", CultureInfo.InvariantCulture) + " s"));
            }
        }

        private void Add(string what, string why, BodyDescription with, Omissions mayLeaveOut) =>
            _leftOut.Add(new Omission(what, why, with, mayLeaveOut));

        private static BodyDescription Copy(BodyDescription body) => body.Copy(body.Name, body.Mass);

        /// <summary>The same body with moments that differ, as far as its moments allow.</summary>
        private static BodyDescription ThreeMoments(BodyDescription body)
        {
            Vector3d i = body.Mass.PrincipalMoments;
            double least = Math.Min(i.X, Math.Min(i.Y, i.Z));
            // a little more mass on both sides of two planes, so that the new moments are those of a possible body
            Vector3d moments = i + least * new Vector3d(0.2, 0.1, 0.3);
            return body.Copy(body.Name, MassProperties.FromPrincipal(body.Mass.Mass, moments, body.Mass.PrincipalFrame, body.Mass.CenterOfMass));
        }
    }
}
