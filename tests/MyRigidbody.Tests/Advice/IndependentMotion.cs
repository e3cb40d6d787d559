namespace RigidBodyDynamics.Tests;

/// <summary>
/// The motion of one body by a method that shares nothing with the integrators: Newton's and Euler's equations in plain coordinates, by
/// Gragg's midpoint rule extrapolated to order 16 (Hairer, Nørsett, Wanner, Solving Ordinary Differential Equations I, II.9).
/// </summary>
internal sealed class IndependentMotion
{
    private const int Rows = 8;

    private readonly BodyDescription _body;
    private readonly double _longest;
    private readonly int _parts;
    private readonly double[] _cuts;
    private readonly double[] _now, _lost;
    private double _time;

    /// <param name="body">The body, whose factor per step is a rate by now.</param>
    /// <param name="longest">The longest step, s.</param>
    /// <param name="parts">Into how many each of them, and each shorter one that a time or the beginning of an effect asks for, is divided.</param>
    public IndependentMotion(BodyDescription body, double longest, int parts = 1)
    {
        _parts = parts;
        _body = body;
        _longest = longest;
        _cuts = [.. body.Effects.SelectMany(effect => new[] { effect.From, effect.To }).Where(time => time > 0).Distinct().Order()];
        Quaterniond q = body.Start.Orientation.Normalized;
        Vector3d center = body.Start.Position + q.Rotate(body.Mass.CenterOfMass), momentum = body.Mass.Inertia * q.RotateInverse(body.Start.AngularVelocity);
        _now = [center.X, center.Y, center.Z, body.Start.Velocity.X, body.Start.Velocity.Y, body.Start.Velocity.Z, q.W, q.X, q.Y, q.Z, momentum.X, momentum.Y, momentum.Z];
        _lost = new double[_now.Length];
    }

    /// <summary>On to a time not before the last, s.</summary>
    public BodyState At(double time)
    {
        while (_time < time)
        {
            double next = _cuts.Where(cut => cut > _time).Append(time).Min();
            int count = _parts * (int)Math.Ceiling((next - _time) / _longest);
            for (int i = 0; i < count; i++)
                Keep(Step(_now, _time + ((next - _time) * i / count), (next - _time) / count, _time));

            _time = next;
        }

        return State(_now);
    }

    /// <summary>Kahan: what a sum rounds away is added with the next.</summary>
    private void Keep(double[] change)
    {
        for (int i = 0; i < change.Length; i++)
        {
            double add = change[i] - _lost[i], sum = _now[i] + add;
            _lost[i] = (sum - _now[i]) - add;
            _now[i] = sum;
        }
    }

    private double[] Step(double[] from, double time, double length, double since)
    {
        double[][] last = [];
        for (int row = 0; row < Rows; row++)
        {
            // Aitken and Neville: the error of the midpoint rule is a series in the square of its step
            double[][] next = [Midpoint(from, time, length, 2 * (row + 1), since), .. new double[row][]];
            for (int i = 1; i <= row; i++)
            {
                double ratio = (row + 1.0) / (row + 1 - i), factor = 1 / ((ratio * ratio) - 1);
                next[i] = [.. next[i - 1].Zip(last[i - 1], (finer, coarser) => finer + (factor * (finer - coarser)))];
            }

            last = next;
        }

        return last[^1];
    }

    /// <summary>What a step changes: small numbers, whose roundings are small.</summary>
    private double[] Midpoint(double[] from, double time, double length, int count, double since)
    {
        double h = length / count;
        double[] before = new double[from.Length], now = Add(before, h, Slope(from, time, since));
        for (int i = 1; i < count; i++)
            (before, now) = (now, Add(before, 2 * h, Slope(Add(from, 1, now), time + (i * h), since)));

        return now;
    }

    private static double[] Add(double[] y, double h, double[] slope) => [.. y.Select((value, i) => value + (h * slope[i]))];

    private BodyState State(double[] y)
    {
        Quaterniond q = new Quaterniond(y[6], y[7], y[8], y[9]).Normalized;
        Vector3d spin = q.Rotate(Spin(new Vector3d(y[10], y[11], y[12])));
        return new BodyState(new Vector3d(y[0], y[1], y[2]) - q.Rotate(_body.Mass.CenterOfMass), q, new Vector3d(y[3], y[4], y[5]), spin);
    }

    /// <summary>Of an angular momentum, both in body axes.</summary>
    private Vector3d Spin(Vector3d momentum)
    {
        Quaterniond frame = _body.Mass.PrincipalFrame;
        return frame.Rotate(Vector3d.Scale(_body.Mass.InversePrincipalMoments, frame.RotateInverse(momentum)));
    }

    private double[] Slope(double[] y, double time, double since)
    {
        BodyState state = State(y);
        Coasting coasting = Coasting.Free;
        Wrench wrench = default;
        foreach (Effect effect in _body.Effects.Where(effect => effect.From <= since && since < effect.To))
        {
            if (effect.Coast is ICoast coast)
                coast.AddTo(ref coasting, _body.Mass);
            else
                ((IPush)effect.Motion).At(new Instant(0, time), state, _body.Mass, ref wrench);
        }

        Vector3d momentum = new(y[10], y[11], y[12]);
        Vector3d pull = _body.CanMove ? _body.Mass.InverseMass * wrench.Force + coasting.Acceleration - coasting.LinearDampingRate * state.Velocity : Vector3d.Zero;
        // in body axes, where the small component of a body that is about to tumble keeps its digits
        Vector3d twist = _body.CanTurn
            ? Vector3d.Cross(momentum, Spin(momentum)) + state.Orientation.RotateInverse(wrench.Torque) + wrench.BodyTorque - coasting.AngularDampingRate * momentum
            : Vector3d.Zero;
        Quaterniond turn = 0.5 * (new Quaterniond(0, state.AngularVelocity) * new Quaterniond(y[6], y[7], y[8], y[9]));
        return [y[3], y[4], y[5], pull.X, pull.Y, pull.Z, turn.W, turn.X, turn.Y, turn.Z, twist.X, twist.Y, twist.Z];
    }
}
