namespace RigidBodyDynamics
{
    /// <summary>
    /// The lab's five steps with formula 3.3 as printed: x moves with the velocity before the step.
    /// Everything else is <see cref="LabEuler"/>.
    /// </summary>
    internal struct ExplicitEuler : IIntegrator
    {
        private LabEuler _lab;

        public BodyState State => _lab.State;

        public bool IsAsleep => false;

        public bool IsFinite => _lab.IsFinite;

        public bool HasClosedForm => _lab.HasClosedForm;

        public void Start(in Beginning body) => _lab.Start(body);

        public void Push(in Wrench impulse) => _lab.Push(impulse);

        public void Prepare(double duration, in Coasting coasting) => _lab.Prepare(duration, coasting);

        public void Step<TPush>(in Instant now, ref TPush push) where TPush : struct, IPush =>
            _lab.Step(now, ref push, xFromOldVelocity: true);
    }
}
