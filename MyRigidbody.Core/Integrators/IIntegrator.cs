namespace RigidBodyDynamics
{
    /// <summary>
    /// An integrator takes one body from one step to the next. It is a struct that holds all it stores of the body; to add an
    /// integrator, write one such struct; <see cref="Rules.Of{TIntegrator}"/> makes a <see cref="Rule"/> of it.
    /// </summary>
    /// <remarks>
    /// The integrator chooses the form of the state inside (single precision, body axes, cached constants); the state goes in by
    /// <see cref="Start"/> and comes out by <see cref="State"/>. A copy of the struct is a saved body.
    /// </remarks>
    public interface IIntegrator
    {
        /// <summary>The present state of the body.</summary>
        BodyState State { get; }

        /// <summary>True while the integrator has put the body to sleep.</summary>
        bool IsAsleep { get; }

        /// <summary>
        /// False once a number in it, or the square of a velocity, is infinite or NaN (<see cref="BodyState.HasFiniteSquares"/>).
        /// Must be fast: it is read after every call.
        /// </summary>
        bool IsFinite { get; }

        /// <summary>
        /// True while a step of any length, as prepared and without pushes, is one closed form: the body is then not stepped until its
        /// state is read. False is valid for every integrator.
        /// </summary>
        bool HasClosedForm { get; }

        /// <summary>Starts with a body.</summary>
        void Start(in Beginning body);

        /// <summary>
        /// Adds an impulse (N s) and angular impulses about the centre of mass (N m s) at once: velocities change, the pose does not.
        /// A body that cannot move or rotate ignores its part.
        /// </summary>
        void Push(in Wrench impulse);

        /// <summary>Prepares steps of one length with one sum of coasting effects: computes all that such steps have in common.</summary>
        void Prepare(double duration, in Coasting coasting);

        /// <summary>Takes one step of the prepared length.</summary>
        /// <param name="now">The start of the step.</param>
        /// <param name="push">The sum of all pushes.</param>
        void Step<TPush>(in Instant now, ref TPush push) where TPush : struct, IPush;
    }
}
