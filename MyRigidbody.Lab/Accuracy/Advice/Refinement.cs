namespace RigidBodyDynamics.Lab;

/// <summary>Runs a body with shorter and shorter steps.</summary>
internal sealed class Refinement
{
    // no power of two, and no divisor of usual numbers: an oscillation with a period of whole seconds does not coincide with the steps
    private const int LeastIntervals = 61;
    private const int LeastBetweenCuts = 4, MostIntervals = 1 << 19;
    private const double LongestInterval = 1, NearlyStill = 1e-9, LastBit = 1.0 / (1L << 52);

    // two computations of a position differ by some last bits of it even after convergence
    private const double BitsOfPosition = 4;

    // an integrator that gains less than this factor is dropped where another may be better
    private const double SlowestGain = 6;

    private readonly BodyDescription _body;
    private readonly double _end;
    private readonly IReadOnlyList<double> _cuts;
    private BrokenEffectException? _broken;

    public Refinement(BodyDescription body, double end)
    {
        _body = body;
        _end = end;
        _cuts = new Cuts(body, end).Times;
    }

    /// <summary>The path, its largest distance from the path with steps twice as long, and the effect of the last bit of the start.</summary>
    public (MotionPath Path, double Uncertainty, double Floor) Run(double still, Action<double> progress)
    {
        (MotionPath? Path, Rule Rule, int Parts, double Change) best = (null, Rules.Default, 0, double.PositiveInfinity);
        foreach (Rule rule in new[] { HighestOrder(), Rules.RungeKutta4 })
        {
            double before = double.PositiveInfinity;
            int slow = 0;
            bool rounds = false;
            MotionPath? last = Path(rule, 1, 0);
            for (int parts = 2; Intervals(parts).Sum() <= MostIntervals && best.Change > still && slow < 2 && !rounds; parts *= 2)
            {
                MotionPath? next = Path(rule, parts, 0);
                double change = Apart(last, next);
                progress(Math.Min(1, Intervals(parts).Sum() / (double)MostIntervals));
                // a small change that grows again consists of roundings
                rounds = change >= before && before < NearlyStill;
                slow = before < double.PositiveInfinity && change < 0.01 && before < SlowestGain * change ? slow + 1 : 0;
                if (change < best.Change)
                    best = (next, rule, parts, change);

                last = next;
                before = change;
            }

            if (best.Change <= still || rounds)
                break;
        }

        if (best.Path == null && _broken != null)
            throw _broken;

        if (best.Path == null)
            throw Guard.Refused("body", _body.Name, "must have a motion without infinite numbers");

        return (best.Path, best.Change, Math.Min(Apart(best.Path, Path(best.Rule, best.Parts, LastBit)), double.MaxValue));
    }

    private static Rule HighestOrder()
    {
        Rule highest = Rules.All[0];
        foreach (Rule rule in Rules.All)
        {
            // UnityRigidbody has limits of its own
            if (rule.Order >= highest.Order && rule != Rules.UnityRigidbody)
                highest = rule;
        }

        return highest;
    }

    /// <summary>The number of intervals between two cuts.</summary>
    private IEnumerable<int> Intervals(int parts)
    {
        double longest = Math.Min(_end / LeastIntervals, LongestInterval);
        return _cuts.Skip(1).Select((cut, i) => parts * (int)Math.Max(LeastBetweenCuts, Math.Ceiling((cut - _cuts[i]) / longest)));
    }

    /// <summary>The motion from a start that is changed by a relative amount; null where the steps are too long for the effects.</summary>
    private MotionPath? Path(Rule rule, int parts, double nudge)
    {
        int[] intervals = [.. Intervals(parts)];
        List<double> lengths = [];
        for (int i = 0; i < intervals.Length; i++)
            lengths.AddRange(Enumerable.Repeat((_cuts[i + 1] - _cuts[i]) / intervals[i], intervals[i]));

        BodyDescription body = _body.Copy(_body.Name, _body.Mass);
        BodyState s = body.Start;
        body.Rule = rule;
        body.Start = new BodyState(
            Nudged(s.Position, nudge),
            new Quaterniond(s.Orientation.W * (1 + nudge), Nudged(s.Orientation.Vector, -nudge)),
            Nudged(s.Velocity, nudge),
            Vector3d.Zero);
        body.AngularVelocityInBody = Nudged(_body.AngularVelocityInBody, nudge);
        TimeSteps steps = TimeSteps.Of(lengths);
        Simulation simulation = new Simulation(steps, body);
        BodyState[] states = new BodyState[lengths.Count + 1];
        states[0] = simulation.Bodies[0].State;
        try
        {
            for (int i = 1; i < states.Length; i++)
            {
                simulation.Step();
                states[i] = simulation.Bodies[0].State;
            }
        }
        catch (BrokenEffectException broken)
        {
            _broken = broken;
            return null;
        }
        catch (StateOverflowException)
        {
            // the integration diverges with steps of this length: the state is NaN
            BodyState nowhere = new BodyState(new Vector3d(double.NaN, 0, 0), Quaterniond.Identity, Vector3d.Zero, Vector3d.Zero);
            for (long i = simulation.StepsDone + 1; i < states.Length; i++)
                states[i] = nowhere;
        }

        return new MotionPath(body, _cuts, intervals, steps, states);
    }

    private static Vector3d Nudged(Vector3d v, double e) => new Vector3d(v.X * (1 + e), v.Y * (1 - e), v.Z * (1 + e));

    /// <summary>The largest distance of a path from the states of one with as many or more, at least some last bits of the compared numbers.</summary>
    private static double Apart(MotionPath? path, MotionPath? other)
    {
        if (path == null || other == null)
            return double.PositiveInfinity;

        double largest = 0;
        for (int i = 0; i < other.States.Count; i++)
        {
            BodyState right = other.States[i];
            double apart = MotionPath.Apart(path.At(other.Times[i]), right);
            if (!(apart < double.PositiveInfinity))
                return double.PositiveInfinity;

            largest = Math.Max(largest, Math.Max(apart, BitsOfPosition * LastBit * Math.Max(1, right.Position.Length)));
        }

        return largest;
    }
}
