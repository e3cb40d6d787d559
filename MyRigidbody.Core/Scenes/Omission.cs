namespace RigidBodyDynamics
{
    /// <summary>Something that a body's motion does without, and why it may.</summary>
    internal sealed class Omission
    {
        internal Omission(string what, string why, BodyDescription with, Omissions mayLeaveOut)
        {
            What = what;
            Why = why;
            With = with;
            MayLeaveOut = mayLeaveOut;
        }

        /// <summary>What is left out.</summary>
        public string What { get; }

        /// <summary>Why the motion is the same without it, or that the scene does not ask for it.</summary>
        public string Why { get; }

        /// <summary>A body that has it, so that one can measure what it would cost: simulate it with <see cref="MayLeaveOut"/>.</summary>
        public BodyDescription With { get; }

        /// <summary>What may be left out of that body.</summary>
        public Omissions MayLeaveOut { get; }

        public override string ToString() => What + " (" + Why + ")";
    }
}
