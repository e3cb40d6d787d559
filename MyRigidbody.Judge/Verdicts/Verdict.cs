using System.Collections.Generic;
using System.Linq;

namespace RigidBodyDynamics.Judging
{
    /// <summary>The verdict on a script: a mark for each of the five steps, and the findings that justify the marks.</summary>
    public sealed class Verdict
    {
        public static readonly IReadOnlyList<Step> FiveSteps =
            new[] { Step.Velocity, Step.AngularVelocity, Step.Position, Step.Orientation, Step.Damping };

        private readonly Dictionary<Step, Mark> _marks;

        public Verdict(IReadOnlyDictionary<Step, Mark> marks, IEnumerable<Finding> findings)
            : this(marks, findings, false) { }

        private Verdict(IReadOnlyDictionary<Step, Mark> marks, IEnumerable<Finding> findings, bool isRefused)
        {
            _marks = FiveSteps.ToDictionary(s => s, s => marks.TryGetValue(s, out Mark mark) ? mark : Mark.Unknown);
            Findings = findings.OrderBy(f => f.Step).ToArray();
            Outcome = isRefused ? Outcome.Refused : Sum();
        }

        public Outcome Outcome { get; }

        public IReadOnlyList<Finding> Findings { get; }

        /// <summary>True if the keys' forces, the torque or I_ref differ from the given code.</summary>
        public bool GivenChanged => Findings.Any(f => f.Step == Step.Given);

        public Mark this[Step step] => _marks.TryGetValue(step, out Mark mark) ? mark : Mark.Unknown;

        /// <summary>The verdict on a script that was not run to its end.</summary>
        public static Verdict Refused(params Finding[] findings) => new Verdict(new Dictionary<Step, Mark>(), findings, true);

        /// <summary>The same marks with one more finding, about the name, the package or the code.</summary>
        public Verdict With(Finding finding) => new Verdict(_marks, Findings.Concat(new[] { finding }), Outcome == Outcome.Refused);

        /// <summary>The same verdict with each finding changed, for instance by its line of the script.</summary>
        public Verdict Each(System.Func<Finding, Finding> change) => new Verdict(_marks, Findings.Select(change), Outcome == Outcome.Refused);

        private Outcome Sum()
        {
            if (_marks.Values.Any(m => m == Mark.Wrong || m == Mark.Missing) || Findings.Any(f => !f.IsDoubtful))
                return Outcome.Wrong;
            return _marks.Values.Any(m => m != Mark.Right) || Findings.Any() ? Outcome.Doubtful : Outcome.Right;
        }
    }
}
