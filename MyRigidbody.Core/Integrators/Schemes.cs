namespace RigidBodyDynamics
{
    /// <summary>A sequence of pushes and free motion: b₀ a₁ b₁ a₂ … b_n, as parts of a step.</summary>
    internal interface IScheme
    {
        /// <summary>The parts of a step for pushes, one more than there are drifts.</summary>
        double[] Kicks { get; }

        /// <summary>The parts of a step for free motion between pushes.</summary>
        double[] Drifts { get; }

        /// <summary>True if time passes during free motion and stands still during a push.</summary>
        bool HoldsTime { get; }

        /// <summary>
        /// For pushes that read a velocity, while time is held: parts α₁ α₂ … of a step, alternately for pushes one after another and
        /// then free motion, and for the mirror image of that. Their order is the same whatever is read, and whether or not the sum
        /// of pushes has an exact flow: each need only have one, or be reversible. Null where a push that reads a velocity is applied
        /// forwards and backwards within each part of <see cref="Kicks"/>.
        /// </summary>
        double[] Mirrored { get; }
    }

    /// <summary>Half a push, free motion, half a push (Strang): order 2; each push by its mean over its half.</summary>
    internal struct Order2 : IScheme
    {
        private static readonly double[] HalfKicks = { 0.5, 0.5 };
        private static readonly double[] WholeDrift = { 1 };

        public double[] Kicks => HalfKicks;

        public double[] Drifts => WholeDrift;

        public bool HoldsTime => false;

        public double[] Mirrored => null;
    }

    /// <summary>
    /// Order 4 with six stages: S. Blanes, P. C. Moan, "Practical symplectic partitioned Runge–Kutta and
    /// Runge–Kutta–Nyström methods", J. Comput. Appl. Math. 142 (2002): SRKN 6 b for pushes that read only pose and time (the
    /// free motion may be a rotation, and need not be the drift of a quadratic form), S 6 for those that read a velocity, its
    /// a₁ b₁ a₂ … here as a₁ = α₁, b₁ = α₁ + α₂, a₂ = α₂ + α₃, … Two stages go back in time: damping of c h above ten grows there.
    /// </summary>
    internal struct Order4 : IScheme
    {
        private static readonly double[] B = Palindrome(
            new[] { 0.0829844064174052, 0.396309801498368, -0.0390563049223486 }, middleTwice: false);

        private static readonly double[] A = Palindrome(new[] { 0.245298957184271, 0.604872665711080 }, middleTwice: true);

        private static readonly double[] Alpha = Palindrome(
            new[] { 0.0792036964311957, 0.1303114101821663, 0.2228614958676077, -0.3667132690474257, 0.3246481886897062 }, middleTwice: true);

        public double[] Kicks => B;

        public double[] Drifts => A;

        public bool HoldsTime => true;

        public double[] Mirrored => Alpha;

        /// <summary>
        /// c₁ … c_k m c_k … c₁, or c₁ … c_k m m c_k … c₁, with m such that the sum is 1. The coefficients are given to 15
        /// digits; the sum must be 1 to the last bit, because a constant push is multiplied by it.
        /// </summary>
        internal static double[] Palindrome(double[] outer, bool middleTwice)
        {
            double sum = 0;
            foreach (double c in outer)
                sum += c;

            double middle = middleTwice ? 0.5 - sum : 1 - 2 * sum;
            double[] all = new double[2 * outer.Length + (middleTwice ? 2 : 1)];
            for (int i = 0; i < all.Length; i++)
            {
                int fromEnd = System.Math.Min(i, all.Length - 1 - i);
                all[i] = fromEnd < outer.Length ? outer[fromEnd] : middle;
            }

            return all;
        }
    }

    /// <summary>Order 6: the same paper, SRKN 11 b with eleven stages, and S 10 with ten for pushes that read a velocity.</summary>
    internal struct Order6 : IScheme
    {
        private static readonly double[] B = Order4.Palindrome(
            new[] { 0.0414649985182624, 0.198128671918067, -0.0400061921041533, 0.0752539843015807, -0.0115113874206879 },
            middleTwice: true);

        private static readonly double[] A = Order4.Palindrome(
            new[] { 0.123229775946271, 0.290553797799558, -0.127049212625417, -0.246331761062075, 0.357208872795928 },
            middleTwice: false);

        private static readonly double[] Alpha = Order4.Palindrome(
            new[]
            {
                0.0502627644003922, 0.0985536835006498, 0.3149606169276942, -0.4473464826954782, 0.4924263724898759,
                -0.4251187677976909, 0.2370639139781219, 0.1956024886000531, 0.3463581898507269,
            },
            middleTwice: true);

        public double[] Kicks => B;

        public double[] Drifts => A;

        public bool HoldsTime => true;

        public double[] Mirrored => Alpha;
    }
}
