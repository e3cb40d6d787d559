using System.Collections.Generic;
using System.Linq;

namespace RigidBodyDynamics.Judging
{
    /// <summary>Marks and findings from the best explanation.</summary>
    internal sealed class Conclusion
    {
        private readonly IReadOnlyList<Observation> _frames;
        private readonly Explanation _explanation;
        private readonly Dictionary<Step, Mark> _marks = new Dictionary<Step, Mark>();
        private readonly List<Finding> _findings = new List<Finding>();

        public Conclusion(IReadOnlyList<Observation> frames, Explanation explanation)
        {
            _frames = frames;
            _explanation = explanation;
        }

        public Verdict Verdict()
        {
            _findings.AddRange(GivenCode.Findings(_frames, _explanation));
            Gain(Step.Velocity, _explanation.Velocity, true);
            Gain(Step.AngularVelocity, _explanation.AngularVelocity, false);
            Position();
            Orientation();
            Damping();
            return new Verdict(_marks, _findings);
        }

        private void Gain(Step step, Chain chain, bool ofForce)
        {
            if (chain.Links.Length == 0)
            {
                _marks[step] = Mark.Unknown;
                return;
            }

            if (chain.GainIsRight)
            {
                _marks[step] = Mark.Right;
                if (chain.Code != null)
                    Doubtful(Words.Finding(step, chain.Code, "I⁻¹ τ", "I⁻¹ (τ − ω × I ω)"));
                return;
            }

            GainDiagnosis diagnosis = new GainDiagnosis(chain, ofForce);
            Wrong(step, diagnosis.Findings(), diagnosis.IsMissing, chain, chain.First(Miss.Gain, Miss.Both, Miss.Either));
        }

        private void Position()
        {
            Carry carry = _explanation.Position;
            if (_frames.All(o => o.Moved.Length == 0 || o.IsSetAnew && o.Moved.Length < 1e-6))
                Missing(Step.Position, "Δx = Δt v");
            else if (carry.Code == "second-order")
                Doubtful(Words.Finding(Step.Position, "x-second-order", "Δx = Δt v", "Δx = Δt (v + ½Δt F/m)"));
            else if (carry.IsRight)
                _marks[Step.Position] = carry.Seen > 0 ? Mark.Right : Mark.Unknown;
            else
                Wrong(Step.Position, PositionDiagnosis.Findings(_explanation), false, _explanation.Velocity, carry.Missed[0]);
        }

        private void Orientation()
        {
            Observation longer = OrientationDiagnosis.Lengthening(_frames);
            Carry carry = _explanation.Orientation;
            if (longer != null)
            {
                _marks[Step.Orientation] = Mark.Wrong;
                _findings.Add(Words.Finding(Step.Orientation, "not-normalised", "|q| = 1", "|q| = " + Text.Of(longer.After.OwnOrientation.Value.Length)).From(longer.Run.Name, longer.Index));
            }
            else if (_frames.All(o => o.Turn.Imaginary.Length < 1e-6))
            {
                Missing(Step.Orientation, "Δq = [0, ½Δt ω] q");
            }
            else if (carry.Code != null)
            {
                Doubtful(Turned(carry.Code));
            }
            else if (carry.IsRight)
            {
                _marks[Step.Orientation] = carry.Seen > 0 ? Mark.Right : Mark.Unknown;
            }
            else
            {
                Wrong(Step.Orientation, OrientationDiagnosis.Findings(_explanation), false, _explanation.AngularVelocity, carry.Missed[0]);
            }
        }

        private static Finding Turned(string code)
        {
            switch (code)
            {
                case "exact-turn": return Words.Finding(Step.Orientation, code, "2 atan(½Δt |ω|)", "Δt |ω|");
                case "euler-turn": return Words.Finding(Step.Orientation, code, "[0, ½Δt ω] q", "Euler(Δt ω) q");
                default: return Words.Finding(Step.Orientation, "q-second-order", "½Δt ω", "½Δt (ω + ½Δt I⁻¹ τ)");
            }
        }

        private void Damping()
        {
            if (_explanation.Velocity.Links.Length == 0 && _explanation.AngularVelocity.Links.Length == 0)
            {
                _marks[Step.Damping] = Mark.Unknown;
            }
            else if (_explanation.IsDampedRightly)
            {
                _marks[Step.Damping] = Mark.Right;
            }
            else
            {
                DampingDiagnosis diagnosis = new DampingDiagnosis(_explanation);
                Chain chain = _explanation.Velocity.DecayIsRight ? _explanation.AngularVelocity : _explanation.Velocity;
                Finding[] findings = diagnosis.Findings().ToArray();
                if (findings[0].IsDoubtful)
                    Doubtful(findings[0]);
                else
                    Wrong(Step.Damping, findings, diagnosis.IsMissing, chain, chain.First(Miss.Decay, Miss.Both));
            }
        }

        private void Missing(Step step, string expected)
        {
            _marks[step] = Mark.Missing;
            _findings.Add(Words.Finding(step, "not-done", expected, "0"));
        }

        private void Doubtful(Finding finding)
        {
            _marks[finding.Step] = Mark.Doubtful;
            _findings.Add(finding.ForInstructor());
        }

        private void Wrong(Step step, IEnumerable<Finding> findings, bool isMissing, Chain chain, int? link)
        {
            _marks[step] = isMissing ? Mark.Missing : Mark.Wrong;
            foreach (Finding finding in findings)
                _findings.Add(link.HasValue ? finding.From(chain.Links[link.Value].At.Run.Name, chain.Links[link.Value].At.Index) : finding);
        }
    }
}
