using System;
using System.Collections.Generic;

namespace RigidBodyDynamics.Judging
{
    /// <summary>A possible form of step 3 or 4: a vector that is some coefficient times the velocity.</summary>
    internal sealed class CarryShape
    {
        public CarryShape(string code, string formula, Func<Observation, Vector> carried)
        {
            Code = code;
            Formula = formula;
            Carried = carried;
        }

        /// <summary>Null: the sheet's.</summary>
        public string Code { get; }

        public string Formula { get; }

        public Func<Observation, Vector> Carried { get; }
    }

    /// <summary>The form and the velocity that fit most frames, and the coefficient in each.</summary>
    internal sealed class CarryDiagnosis
    {
        /// <summary>A later form has to fit more by this share of the frames.</summary>
        private const double BetterBy = 1e-3;

        public CarryDiagnosis(Chain chain, IEnumerable<CarryShape> shapes, Func<Observation, Vector, double> tolerance)
        {
            Share = -1;
            Gains = new Samples(2e-3);
            foreach (CarryShape shape in shapes)
            {
                foreach (Reading reading in new[] { Reading.New, Reading.Old })
                    Try(chain, shape, reading, tolerance);
            }
        }

        public CarryShape Shape { get; private set; }

        public Samples Gains { get; private set; }

        /// <summary>The share of frames that the form explains with a separate coefficient in each.</summary>
        public double Share { get; private set; }

        /// <summary>What the script has in place of Δt, as the end of a code; null where it is Δt.</summary>
        public string Factor(TimeStep step)
        {
            Func<Observation, double> h = step.At;
            const double Degrees = 180 / Math.PI;
            KeyValuePair<string, Func<Observation, double>>[] laws =
            {
                Law(null, h), Law("sign", o => -h(o)), Law("no-dt", _ => 1), Law("time-for-dt", o => o.Time), Law("time-for-dt", o => o.Time - o.Delta),
                Law("twice", o => 2 * h(o)), Law("half", o => h(o) / 2), Law("degrees", o => h(o) / Degrees), Law("degrees-no-dt", _ => 1 / Degrees),
                Law("to-degrees", o => h(o) * Degrees), Law("no-dt", _ => 2), Law("no-dt", _ => 0.5), Law("dt-twice", o => h(o) * h(o)), Law("dt-twice", o => h(o) * h(o) / 2),
                Law("two-time-steps", TimeStep.OfFrame.At), Law("two-time-steps", TimeStep.Usual.At),
            };
            foreach (KeyValuePair<string, Func<Observation, double>> law in laws)
            {
                if (Gains.Follow(law.Value))
                    return law.Key;
            }

            return "factor";
        }

        private static KeyValuePair<string, Func<Observation, double>> Law(string code, Func<Observation, double> law) =>
            new KeyValuePair<string, Func<Observation, double>>(code, law);

        private void Try(Chain chain, CarryShape shape, Reading reading, Func<Observation, Vector, double> tolerance)
        {
            // no other form can fit more
            if (Share >= 1 - BetterBy)
                return;
            Samples gains = new Samples(2e-3);
            int seen = 0;
            for (int i = 0; i < chain.Links.Length; i++)
            {
                Observation o = chain.Links[i].At;
                Vector velocity = reading.Velocity(chain, i), carried = shape.Carried(o);
                if (!o.IsVaried || !velocity.IsFinite || !carried.IsFinite || velocity.Length < 0.3 || velocity.Length > 1e4)
                    continue;
                seen++;
                Coefficients one = Coefficients.Of(carried, velocity);
                if (one.Residual <= tolerance(o, carried))
                    gains.Add(o, one.First);
            }

            double share = seen < 10 ? 0 : gains.Count / (double)seen;
            if (share <= Share + BetterBy)
                return;
            Share = share;
            Shape = shape;
            Gains = gains;
        }
    }
}
