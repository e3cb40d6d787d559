namespace RigidBodyDynamics
{
    /// <summary>A part left out of a body's motion, and the reason.</summary>
    internal sealed class Omission
    {
        internal Omission(string what, string why, BodyDescription with, Omissions mayLeaveOut)
        {
            What = what;
            Why = why;
            With = with;
            MayLeaveOut = mayLeaveOut;
        }

        /// <summary>The part that is left out.</summary>
        public string What { get; }

        /// <summary>Why the motion is the same without it, or that the scene does not ask for it.</summary>
        public string Why { get; }

        /// <summary>A body that has the part, so that its cost can be measured: simulate it with <see cref="MayLeaveOut"/>.</summary>
        public BodyDescription With { get; }

        /// <summary>What may be left out of that body.</summary>
        public Omissions MayLeaveOut { get; }

        public override string ToString() => What + " (" + Why + ")";
    }
}
