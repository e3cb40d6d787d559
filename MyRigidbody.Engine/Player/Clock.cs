namespace RigidBodyDynamics.Engine
{
    /// <summary>
    /// Divides frames into fixed steps: a frame adds its length, times the time scale, to a balance, from which as many fixed steps are
    /// taken as fit.
    /// </summary>
    internal static class Clock
    {
        private static double _frameTime, _owed;

        public static float FixedDeltaTime { get; set; }

        public static float MaximumDeltaTime { get; set; }

        public static float TimeScale { get; set; }

        public static double FixedTime { get; private set; }

        public static double UnscaledTime { get; private set; }

        public static double FrameLength { get; private set; }

        public static double UnscaledFrameLength { get; private set; }

        public static int Frames { get; private set; }

        public static bool IsInFixedStep { get; private set; }

        public static double Now => IsInFixedStep ? FixedTime : _frameTime;

        public static void Reset()
        {
            FixedDeltaTime = 0.02f;
            MaximumDeltaTime = 1f / 3;
            TimeScale = 1;
            _frameTime = _owed = FixedTime = UnscaledTime = FrameLength = UnscaledFrameLength = 0;
            Frames = 0;
            IsInFixedStep = false;
        }

        /// <summary>Sets the time, instead of counting it.</summary>
        public static void Set(double time, double frameLength, double fixedStep, int frame, bool isInFixedStep)
        {
            FixedDeltaTime = (float)fixedStep;
            _frameTime = FixedTime = UnscaledTime = time;
            FrameLength = UnscaledFrameLength = frameLength;
            Frames = frame;
            IsInFixedStep = isInFixedStep;
        }

        public static void BeginFrame(double seconds)
        {
            Frames++;
            UnscaledFrameLength = seconds;
            UnscaledTime += seconds;
            FrameLength = System.Math.Min(seconds, MaximumDeltaTime) * TimeScale;
            _frameTime += FrameLength;
            _owed += FrameLength;
        }

        /// <summary>Begins the next fixed step if one is due.</summary>
        public static bool BeginFixedStep()
        {
            IsInFixedStep = TimeScale > 0 && _owed >= FixedDeltaTime;
            if (!IsInFixedStep)
                return false;

            _owed -= FixedDeltaTime;
            FixedTime += FixedDeltaTime;
            return true;
        }
    }
}
