using RigidBodyDynamics.Engine;

namespace UnityEngine
{
    /// <summary>Time of the game.</summary>
    public static class Time
    {
        /// <summary>Time of the frame; within FixedUpdate, of the fixed step.</summary>
        public static float time => (float)Clock.Now;

        public static float deltaTime => Clock.IsInFixedStep ? fixedDeltaTime : (float)Clock.FrameLength;

        public static float fixedTime => (float)Clock.FixedTime;

        public static float fixedDeltaTime
        {
            get => Clock.FixedDeltaTime;
            set => Clock.FixedDeltaTime = value;
        }

        public static float maximumDeltaTime
        {
            get => Clock.MaximumDeltaTime;
            set => Clock.MaximumDeltaTime = value;
        }

        public static float timeScale
        {
            get => Clock.TimeScale;
            set => Clock.TimeScale = value;
        }

        public static float unscaledTime => (float)Clock.UnscaledTime;

        public static float unscaledDeltaTime => (float)Clock.UnscaledFrameLength;

        public static int frameCount => Clock.Frames;

        public static float smoothDeltaTime => deltaTime;

        public static float timeSinceLevelLoad => time;

        public static float realtimeSinceStartup => unscaledTime;

        public static float fixedUnscaledTime => fixedTime;

        public static float fixedUnscaledDeltaTime => fixedDeltaTime;

        public static int captureFramerate { get; set; }

        public static double timeAsDouble => Clock.Now;

        public static double fixedTimeAsDouble => Clock.FixedTime;

        public static bool inFixedTimeStep => Clock.IsInFixedStep;
    }
}
