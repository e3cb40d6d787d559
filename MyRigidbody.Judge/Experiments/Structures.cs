using System;
using System.Collections.Generic;

namespace RigidBodyDynamics.Judging
{
    /// <summary>
    /// Structs of an engine that it reads directly, where reflection would read them member by member: the same numbers, and much
    /// faster where no code is compiled at run time.
    /// </summary>
    public static class Structures
    {
        private static readonly Dictionary<Type, Func<object, double[]>> Known = new Dictionary<Type, Func<object, double[]>>();

        /// <summary>Registers a direct reader of a struct.</summary>
        /// <param name="read">Its numbers: x y z; x y z w; or the nine of a matrix, row by row.</param>
        public static void Know<T>(Func<T, double[]> read)
            where T : struct => Known[typeof(T)] = structure => read((T)structure);

        /// <summary>The direct reader; null where there is none.</summary>
        internal static Func<object, double[]> Of(Type type) => Known.TryGetValue(type, out Func<object, double[]> read) ? read : null;
    }
}
