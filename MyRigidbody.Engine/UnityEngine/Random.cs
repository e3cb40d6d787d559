using System;

namespace UnityEngine
{
    /// <summary>Random numbers: the same in every world, so that a run can be repeated.</summary>
    public static class Random
    {
        private static System.Random _source = new System.Random(0);

        /// <summary>0 to 1.</summary>
        public static float value => (float)_source.NextDouble();

        public static Vector3 insideUnitSphere => onUnitSphere * (float)Math.Pow(_source.NextDouble(), 1.0 / 3);

        public static Vector3 onUnitSphere
        {
            get
            {
                double z = 2 * _source.NextDouble() - 1, angle = 2 * Math.PI * _source.NextDouble(), radius = Math.Sqrt(1 - z * z);
                return new Vector3((float)(radius * Math.Cos(angle)), (float)(radius * Math.Sin(angle)), (float)z);
            }
        }

        public static Quaternion rotation
        {
            get
            {
                Vector3 axis = onUnitSphere;
                return Quaternion.AngleAxis(Range(0f, 360f), axis);
            }
        }

        public static void InitState(int seed) => _source = new System.Random(seed);

        public static float Range(float minInclusive, float maxInclusive) => minInclusive + (maxInclusive - minInclusive) * value;

        public static int Range(int minInclusive, int maxExclusive) =>
            minInclusive >= maxExclusive ? minInclusive : _source.Next(minInclusive, maxExclusive);
    }
}
