namespace UnityEngine
{
    // interpolation of values and angles
    public partial struct Mathf
    {
        public static float Lerp(float a, float b, float t) => LerpUnclamped(a, b, Clamp01(t));

        public static float LerpUnclamped(float a, float b, float t) => a + (b - a) * t;

        /// <summary>Degrees, along the shorter arc.</summary>
        public static float LerpAngle(float a, float b, float t) => a + DeltaAngle(a, b) * Clamp01(t);

        public static float InverseLerp(float a, float b, float value) => a == b ? 0 : Clamp01((value - a) / (b - a));

        public static float MoveTowards(float current, float target, float maxDelta) =>
            Abs(target - current) <= maxDelta ? target : current + Sign(target - current) * maxDelta;

        public static float MoveTowardsAngle(float current, float target, float maxDelta)
        {
            float way = DeltaAngle(current, target);
            return -maxDelta < way && way < maxDelta ? target : MoveTowards(current, current + way, maxDelta);
        }

        /// <summary>3 t² − 2 t³ between the two.</summary>
        public static float SmoothStep(float from, float to, float t)
        {
            float part = Clamp01(t);
            part = part * part * (3 - 2 * part);
            return to * part + from * (1 - part);
        }

        public static float Gamma(float value, float absmax, float gamma)
        {
            float size = Abs(value), result = size > absmax ? size : Pow(size / absmax, gamma) * absmax;
            return value < 0 ? -result : result;
        }

        /// <summary>The remainder of t after whole lengths.</summary>
        public static float Repeat(float t, float length) => Clamp(t - Floor(t / length) * length, 0, length);

        /// <summary>Up to the length and back again.</summary>
        public static float PingPong(float t, float length) => length - Abs(Repeat(t, length * 2) - length);

        /// <summary>The shorter rotation from one angle to another, degrees, −180 to 180.</summary>
        public static float DeltaAngle(float current, float target)
        {
            float way = Repeat(target - current, 360);
            return way > 180 ? way - 360 : way;
        }

        public static float SmoothDamp(float current, float target, ref float currentVelocity, float smoothTime) =>
            SmoothDamp(current, target, ref currentVelocity, smoothTime, Infinity, Time.deltaTime);

        public static float SmoothDamp(float current, float target, ref float currentVelocity, float smoothTime, float maxSpeed) =>
            SmoothDamp(current, target, ref currentVelocity, smoothTime, maxSpeed, Time.deltaTime);

        /// <summary>
        /// A spring without overshoot: x″ = ω² (target − x) − 2 ω x′, ω = 2 / smoothTime, stepped with
        /// exp(−ω dt) ≈ 1 / (1 + ω dt + 0.48 (ω dt)² + 0.235 (ω dt)³).
        /// </summary>
        public static float SmoothDamp(float current, float target, ref float currentVelocity, float smoothTime, float maxSpeed, float deltaTime)
        {
            float time = Max(0.0001f, smoothTime), rate = 2 / time, turn = rate * deltaTime;
            float decay = 1 / (1 + turn + 0.48f * turn * turn + 0.235f * turn * turn * turn);
            float away = Clamp(current - target, -maxSpeed * time, maxSpeed * time), goal = current - away;
            float push = (currentVelocity + rate * away) * deltaTime, next = goal + (away + push) * decay;
            currentVelocity = (currentVelocity - rate * push) * decay;
            if (target - current > 0 != next > target)
                return next;

            currentVelocity = 0;
            return target;
        }

        public static float SmoothDampAngle(float current, float target, ref float currentVelocity, float smoothTime) =>
            SmoothDamp(current, current + DeltaAngle(current, target), ref currentVelocity, smoothTime);

        public static float SmoothDampAngle(float current, float target, ref float currentVelocity, float smoothTime, float maxSpeed) =>
            SmoothDamp(current, current + DeltaAngle(current, target), ref currentVelocity, smoothTime, maxSpeed);

        public static float SmoothDampAngle(float current, float target, ref float currentVelocity, float smoothTime, float maxSpeed, float deltaTime) =>
            SmoothDamp(current, current + DeltaAngle(current, target), ref currentVelocity, smoothTime, maxSpeed, deltaTime);

        public static float GammaToLinearSpace(float value) =>
            value <= 0.04045f ? value / 12.92f : value < 1 ? Pow((value + 0.055f) / 1.055f, 2.4f) : Pow(value, 2.2f);

        public static float LinearToGammaSpace(float value) =>
            value <= 0 ? 0 : value <= 0.0031308f ? 12.92f * value : value < 1 ? 1.055f * Pow(value, 1 / 2.4f) - 0.055f : Pow(value, 1 / 2.2f);
    }
}
