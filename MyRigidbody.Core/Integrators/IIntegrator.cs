namespace RigidBodyDynamics
{
    /// <summary>
    /// A rule that takes one body from one step to the next. A struct that holds all it keeps of the body; to add a
    /// rule, write one such struct; <see cref="Rules.Of{TIntegrator}"/> makes a <see cref="Rule"/> of it.
    /// </summary>
    /// <remarks>
    /// The state inside is the rule's own business (single precision, body axes, cached constants); it goes in by
    /// <see cref="Start"/> and comes out by <see cref="State"/>. A copy of the struct is a saved body.
    /// </remarks>
    public interface IIntegrator
    {
        /// <summary>The body as it is now.</summary>
        BodyState State { get; }

        /// <summary>True while the rule has put the body to sleep.</summary>
        bool IsAsleep { get; }

        /// <summary>
        /// False once a number in it, or the square of a velocity, has become infinite or NaN (<see cref="BodyState.HasFiniteSquares"/>).
        /// Quick: it is asked after every call.
        /// </summary>
        bool IsFinite { get; }

        /// <summary>
        /// True while a step of any length, as prepared for and with nothing to push, is one closed form: the body is then not
        /// stepped while nobody looks. False suits every rule.
        /// </summary>
        bool HasClosedForm { get; }

        /// <summary>Takes over a body.</summary>
        void Start(in Beginning body);

        /// <summary>
        /// Adds an impulse (N s) and angular impulses about the centre of mass (N m s) at once: velocities change, the pose stays.
        /// What cannot move or turn does not.
        /// </summary>
        void Push(in Wrench impulse);

        /// <summary>Makes ready for steps of one length with one sum of coasting effects: all that can be computed once.</summary>
        void Prepare(double duration, in Coasting coasting);

        /// <summary>One step of the length prepared for.</summary>
        /// <param name="now">Its start.</param>
        /// <param name="push">The sum of what pushes.</param>
        void Step<TPush>(in Instant now, ref TPush push) where TPush : struct, IPush;
    }
}
