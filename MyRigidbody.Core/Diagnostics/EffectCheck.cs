#if !UNITY_5_3_OR_NEWER
using System;
using System.Collections.Generic;
using System.Globalization;
using System.Linq;

namespace RigidBodyDynamics
{
    /// <summary>
    /// Tests whether an effect does what it declares: what it does and reads, that it adds to the wrench, that its impulse is the
    /// integral of its force and torque and of which order, and its potential. For a test of an effect of your own.
    /// </summary>
    /// <remarks>
    /// It tests 16 states and instants, the same on every runtime: it can find an error, and cannot prove that there is none.
    /// A sum of pushes one of which reads a velocity is itself an approximation; test its parts. When an effect acts is decided by
    /// the plan and not by the effect. Allocation is not measured, because .NET Standard 2.0 cannot.
    /// </remarks>
    public static class EffectCheck
    {
        /// <summary>The beginning of a finding that concerns time or order, while the motion is correct.</summary>
        public const string Hint = "Hint: ";

        /// <summary>One sentence for each error, found on a body of 2.5 kg, in positions of some metres and during ten seconds.</summary>
        public static IReadOnlyList<string> Findings<TPush>(TPush push) where TPush : struct, IPush =>
            // no symmetry, and the centre of mass away from the origin, so that no term vanishes by chance
            Findings(push, MassProperties.FromPrincipal(2.5, new Vector3d(1, 2, 2.5), new Quaterniond(0.9, 0.1, -0.3, 0.2), new Vector3d(0.1, -0.2, 0.3)), BodyState.AtRest, 0, 10);

        /// <summary>One sentence for each error; none if the effect is consistent.</summary>
        /// <param name="push">The effect.</param>
        /// <param name="mass">The body for the test.</param>
        /// <param name="around">The first state (world axes, SI units); the others differ from it by some metres, m/s and rad/s or a
        /// tenth of its own, in any orientation.</param>
        /// <param name="from">The beginning of the tested time, s.</param>
        /// <param name="to">The end of the tested time, s.</param>
        public static IReadOnlyList<string> Findings<TPush>(TPush push, MassProperties mass, BodyState around, double from, double to)
            where TPush : struct, IPush
        {
            new BodyDescription("tried", mass) { Start = around }.Check();
            Guard.Positive(Guard.Finite(to, nameof(to)) - Guard.Finite(from, nameof(from)), "to - from");
            around.Orientation = around.Orientation.Normalized;
            return new Probe<TPush>(push, mass, around, from, to).Findings();
        }

        private sealed class Probe<TPush> where TPush : struct, IPush
        {
            private const int Trials = 16;
            // a duration, s; and, as parts of the largest push, the limit of a rounding and of an error
            private const double Longest = 0.1, Rounding = 1e-12, Error = 1e-9;
            private readonly Instant[] _instants = new Instant[Trials];
            private readonly BodyState[] _states = new BodyState[Trials];
            private readonly List<string> _found = new List<string>();
            private readonly MassProperties _mass;
            // not readonly, so that a call is made on the effect and not on a copy
            private TPush _push;
            private double _force, _torque;
            private ulong _seed = 1;

            public Probe(TPush push, MassProperties mass, in BodyState around, double from, double to)
            {
                _push = push;
                _mass = mass;
                for (int i = 0; i < Trials; i++)
                {
                    _instants[i] = new Instant(i, from + (i + Next()) / Trials * (to - from));
                    // the first state as given: many errors show where all numbers are zero
                    _states[i] = i == 0 ? around : new BodyState(Near(around.Position), NextTurn(), Near(around.Velocity), Near(around.AngularVelocity));
                }
            }

            public IReadOnlyList<string> Findings()
            {
                // an effect without a repeatable finite answer cannot be tested further
                if (!Answers())
                    return _found;

                Declares(EffectTraits.Moves, _force, "force", "N");
                Declares(EffectTraits.Turns, _torque, "torque", "N m");
                Reads(EffectTraits.ReadsTime, "time", (body, next) => body);
                Reads(EffectTraits.ReadsPosition, "position", (body, next) => { body.Position = next.Position; return body; });
                Reads(EffectTraits.ReadsOrientation, "orientation", (body, next) => { body.Orientation = next.Orientation; return body; });
                Reads(EffectTraits.ReadsVelocity, "velocity", (body, next) => { body.Velocity = next.Velocity; return body; });
                Reads(EffectTraits.ReadsAngularVelocity, "angular velocity", (body, next) => { body.AngularVelocity = next.AngularVelocity; return body; });
                Adds();
                int forwards = Integrates(1, false, string.Empty, "Exact is", -1);
                Integrates(-1, false, " a negative time", "the way back is", forwards);
                ComesBack(Integrates(1, true, " while Instant.IsHeld", "Exact4 and Exact6 are", forwards));
                HasPotential();
                return _found;
            }

            /// <summary>False if an answer is not finite, or differs when the same question is repeated.</summary>
            private bool Answers()
            {
                Wrench[] answers = Enumerable.Range(0, 4 * Trials).Select(i => i % 2 == 0 ? At(i / 2 % Trials) : Over(i / 2 % Trials)).ToArray();
                for (int i = 0; i < 2 * Trials; i++)
                {
                    Wrench first = answers[i], again = answers[i + 2 * Trials];
                    string wrong = !first.IsFinite ? "{0} gave force {1} and torque {2}, which is not finite, at t = {5:g3} s, position {6}, velocity {7}: let it give a number for every state that it can meet."
                        : first.Equals(again) ? null : "{0} gave force {1} and torque {2} and then, asked the same, {3} and {4}: keep nothing in the effect from one call to the next, best by a readonly struct.";
                    if (wrong != null)
                        return Found(wrong, i % 2 == 0 ? "At" : "Over", first.Force, first.Torque + first.BodyTorque, again.Force, again.Torque + again.BodyTorque, _instants[i / 2].Time, _states[i / 2].Position, _states[i / 2].Velocity);

                    _force = Math.Max(_force, first.Force.Length);
                    _torque = Math.Max(_torque, Math.Max(first.Torque.Length, first.BodyTorque.Length));
                }

                return true;
            }

            private void Declares(EffectTraits trait, double most, string what, string unit)
            {
                if (most > 0 && !Has(trait))
                    Found("{0} is not declared, and there is a {1} of up to {2:g3} {3}: add EffectTraits.{0} to Traits, or it may be left out.", trait, what, most, unit);
                else if (most == 0 && Has(trait))
                    Found(Hint + "{0} is declared, and in {1} trials there was no {2}: take EffectTraits.{0} out of Traits, so that nobody computes it.", trait, Trials, what);
            }

            /// <summary>Changes one quantity alone to that of the next state, and tests whether the push changes.</summary>
            private void Reads(EffectTraits trait, string what, Func<BodyState, BodyState, BodyState> change)
            {
                double most = Most(i =>
                {
                    Instant now = _instants[trait == EffectTraits.ReadsTime ? (i + 1) % Trials : i];
                    BodyState body = change(_states[i], _states[(i + 1) % Trials]);
                    return Math.Max(Apart(At(i), At(now, body)), Apart(Over(i), Over(now, 1, body)));
                });
                Declares(trait, most > Rounding ? 100 * most : 0, "change with the " + what + " alone", "% of the largest push");
            }

            private void Adds()
            {
                const string Overwrites = "{0} does not add to what other effects have given: where there was some its error is {1:g3} % of the largest push; write += and -=, never =.";
                const string Deaf = "{0} reads a velocity, not what the impulse that comes in has made of it, and its error is {1:g3} % of the largest push: the body now moves as impulse.AppliedTo(body, mass).";
                Vector3d force = Scale(_force) * new Vector3d(1, 2, -0.5), torque = Scale(_torque) * new Vector3d(-1, 0.5, 2);
                Wrench there = new Wrench { Force = force, Torque = torque, BodyTorque = 2 * torque };
                double at = Most(i => Apart(At(_instants[i], _states[i], there), Plus(there, 1, At(i))));
                if (at > Rounding)
                    Found(Overwrites, "At", 100 * at);

                // force and torque separately: one of them may be correct
                foreach (Func<Wrench, Wrench, double> part in new Func<Wrench, Wrench, double>[] { (a, b) => ForceApart(a, b), (a, b) => TorqueApart(a, b) })
                {
                    double over = Most(i => part(Over(_instants[i], 1, _states[i], there), Plus(there, 1, Over(_instants[i], 1, there.AppliedTo(_states[i], _mass)))));
                    double deaf = Most(i => part(Over(_instants[i], 1, _states[i], there), Plus(there, 1, Over(i))));
                    if (over > Rounding)
                        Found(deaf > Rounding ? Overwrites : Deaf, "Over", 100 * over);
                }
            }

            /// <summary>The order of the error over ever shorter times; the highest if there is no error.</summary>
            private int Integrates(int direction, bool isHeld, string when, string who, int isKnown)
            {
                string[] advice = { "add what At gives in that time, the body held in its place", "take the push in the middle of the time for order 2, or its integral", "an exact flow would lift that" };
                double[] errors = Array.ConvertAll(new[] { 1, 2, 4, 8, 16, 32 }, part => Most(i => ErrorOver(i, direction * Longest / part, isHeld)));
                int order = 0, last = Math.Min(Array.FindLastIndex(errors, error => error > Error), errors.Length - 2);
                while (order < 9 && (last < 0 || errors[last] > Math.Sqrt(2) * (1 << order) * errors[last + 1]))
                    order++;

                if (last >= 0 && order != isKnown)
                    Found((order > 1 ? Hint : string.Empty) + "Over{0} is the integral of At to order {1} only: its error is {2:g3} % of the largest push in {3} s, and {4} of order {1} at most; {5}.", when, order, 100 * errors[0], Longest, who, advice[Math.Min(order, 2)]);

                return order;
            }

            /// <summary>A push that reads a velocity and has no exact flow must be reversible, or Exact4 and Exact6 lose their order.</summary>
            private void ComesBack(int order)
            {
                double off = Most(i =>
                {
                    Instant now = new Instant(_instants[i].Step, _instants[i].Time, isHeld: true);
                    Wrench there = Over(now, Longest, _states[i]);
                    return Apart(Over(now, -Longest, there.AppliedTo(_states[i], _mass)), Plus(default(Wrench), -1, there)) / Longest;
                });
                if (order < 9 && off > Error && Has(EffectTraits.ReadsVelocity | EffectTraits.ReadsAngularVelocity))
                    Found(Hint + "Over by −h does not take back what Over by h gave: its error is {0:g3} % of the largest push in {1} s, and Exact4 and Exact6 are of order {2} at most; let it be an exact flow or, like the midpoint rule, one that comes back.", 100 * off, Longest, order);
            }

            /// <summary>
            /// A flow has two properties: its slope at zero is At, and many short times make one long time. Neither test needs a numerical
            /// integral, so pushes that swing fast or jump are tested as precisely as others.
            /// </summary>
            private double ErrorOver(int i, double duration, bool isHeld)
            {
                Instant now = new Instant(_instants[i].Step, _instants[i].Time, isHeld);
                Wrench sum = default(Wrench);
                for (int k = 0; k < 32; k++)
                    sum = Plus(sum, 1, Over(isHeld ? now : now.Later(k * duration / 32), duration / 32, sum.AppliedTo(_states[i], _mass)));

                // the slope at zero from three short times, to six digits: of third order, and times long enough to avoid cancellation
                double little = duration > 0 ? 1e-5 : -1e-5;
                Wrench rise = Plus(Plus(default(Wrench), 32 / (3 * little), Over(now, little / 4, _states[i])), -4 / little, Over(now, little / 2, _states[i]));
                double slope = Apart(Plus(rise, 1 / (3 * little), Over(now, little, _states[i])), At(i));
                return Math.Max(Apart(sum, Over(now, duration, _states[i])) / Math.Abs(duration), slope - 1e-6);
            }

            private void HasPotential()
            {
                const EffectTraits ReadsMotion = EffectTraits.ReadsTime | EffectTraits.ReadsVelocity | EffectTraits.ReadsAngularVelocity;
                double share = Most(i => WorkAround(i));
                if (Has(EffectTraits.HasPotential) && Has(ReadsMotion))
                    Found("HasPotential is declared, and {0} too: a potential knows position and orientation alone; take one of the two out of Traits.", _push.Traits & ReadsMotion);
                else if (Has(EffectTraits.HasPotential) && share > 0)
                    Found("HasPotential is declared, and around a closed way the work is {0:g3} % of what is done to and fro: take EffectTraits.HasPotential out of Traits, or let force and torque be the slope of one energy.", 100 * share);
                else if (!Has(EffectTraits.HasPotential) && share == 0 && !Has(ReadsMotion) && Has(EffectTraits.ReadsPosition | EffectTraits.ReadsOrientation))
                    Found(Hint + "HasPotential is not declared, and around {0} closed ways there was no work: add EffectTraits.HasPotential to Traits, which says that it keeps the energy.", Trials);
            }

            /// <summary>
            /// The work along a closed path of positions and orientations, as a part of its absolute amounts; zero if half as many points
            /// give another value. The trapezoidal rule, whose error falls exponentially for a smooth periodic integrand.
            /// </summary>
            private double WorkAround(int way)
            {
                BodyState body = _states[way], to = _states[(way + 1) % Trials], fro = _states[(way + 2) % Trials];
                Vector3d center = body.Position, a = to.Position - center, b = fro.Position - center;
                Quaterniond start = body.Orientation, c = 0.4 * to.Orientation, d = 0.4 * fro.Orientation;
                double work = 0, halfAsFine = 0, amounts = 0;
                for (int i = 0; i < 512; i++)
                {
                    Elementary.SinCos(i * (6.283185307179586 / 512), out double sin, out double cos);
                    Quaterniond turn = start + cos * c + sin * d, turning = cos * d + -sin * c;
                    body.Orientation = turn.Normalized;
                    body.Position = center + cos * a + sin * b - body.Orientation.Rotate(_mass.CenterOfMass);
                    Wrench push = At(_instants[way], body);
                    Vector3d angular = 2 / turn.LengthSquared * (turning * turn.Conjugate).Vector;
                    double part = Vector3d.Dot(push.Force, cos * b - sin * a) + Vector3d.Dot(push.TorqueInWorld(body.Orientation), angular);
                    work += part;
                    halfAsFine += i % 2 == 0 ? 2 * part : 0;
                    amounts += Math.Abs(part);
                }

                return Math.Abs(work) > Error * amounts + 4 * Math.Abs(work - halfAsFine) ? Math.Abs(work) / amounts : 0;
            }

            private bool Has(EffectTraits any) => (_push.Traits & any) != 0;

            private Wrench At(int i) => At(_instants[i], _states[i]);

            private Wrench At(in Instant now, in BodyState body, Wrench there = default(Wrench))
            {
                _push.At(now, body, _mass, ref there);
                return there;
            }

            private Wrench Over(int i) => Over(_instants[i], 1, _states[i]);

            private Wrench Over(in Instant now, double duration, in BodyState body, Wrench there = default(Wrench))
            {
                _push.Over(now, duration, body, _mass, ref there);
                return there;
            }

            /// <summary>The largest difference, as a part of the largest force or torque.</summary>
            private double Apart(in Wrench a, in Wrench b) => Math.Max(ForceApart(a, b), TorqueApart(a, b));

            private double ForceApart(in Wrench a, in Wrench b) => (a.Force - b.Force).Length / Scale(_force);

            private double TorqueApart(in Wrench a, in Wrench b) =>
                Math.Max((a.Torque - b.Torque).Length, (a.BodyTorque - b.BodyTorque).Length) / Scale(_torque);

            private static double Scale(double largest) => largest > 0 ? largest : 1;

            private static Wrench Plus(in Wrench a, double s, in Wrench b) =>
                new Wrench { Force = a.Force + s * b.Force, Torque = a.Torque + s * b.Torque, BodyTorque = a.BodyTorque + s * b.BodyTorque };

            private static double Most(Func<int, double> ofTrial) => Enumerable.Range(0, Trials).Max(ofTrial);

            private bool Found(string sentence, params object[] values)
            {
                _found.Add(string.Format(CultureInfo.InvariantCulture, sentence, values));
                return false;
            }

            private Vector3d Near(Vector3d v) => v + (3 + 0.1 * v.Length) * new Vector3d(Next() - 0.5, Next() - 0.5, Next() - 0.5);

            private Quaterniond NextTurn() => new Quaterniond(1 + Next(), 2 * Next() - 1, 2 * Next() - 1, 2 * Next() - 1).Normalized;

            // Knuth's linear congruential generator MMIX: the same numbers from 0 to 1 on every runtime
            private double Next() => ((_seed = unchecked(_seed * 6364136223846793005UL + 1442695040888963407UL)) >> 11) / 9007199254740992.0;
        }
    }
}
#endif
