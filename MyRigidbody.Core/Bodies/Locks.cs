using System;

namespace RigidBodyDynamics
{
    /// <summary>
    /// Axes along which a body's centre of mass cannot move (of the world, as on rails), and principal axes about which the body
    /// cannot rotate (fixed in the body, in the order of <see cref="MassProperties.PrincipalMoments"/>, as in a hinge).
    /// </summary>
    /// <remarks>
    /// The constraint acts with a force along the locked axes of the world and a torque about the locked axes of the body, and no
    /// other (d'Alembert's principle; about one locked axis this is G. K. Suslov's body, 1902). So v keeps its other components,
    /// mᵢ v̇ᵢ = Fᵢ, and the angular velocity in principal axes keeps its own, Iᵢ ω̇ᵢ = τᵢ: with an axis locked no gyroscopic term
    /// is left, and without a torque ω is constant in the body and in the world, for any moments. PhysX does the same with a
    /// component of zero in its inverse moments, which Unity's Freeze Rotation sets; Freeze Position locks axes of the world.
    /// </remarks>
    [Flags]
    public enum Locks
    {
        /// <summary>The body is free.</summary>
        None = 0,

        /// <summary>No motion along the x axis of the world.</summary>
        MoveX = 1,

        /// <summary>No motion along the y axis of the world.</summary>
        MoveY = 2,

        /// <summary>No motion along the z axis of the world.</summary>
        MoveZ = 4,

        /// <summary>No rotation about the first principal axis.</summary>
        TurnX = 8,

        /// <summary>No rotation about the second principal axis.</summary>
        TurnY = 16,

        /// <summary>No rotation about the third principal axis.</summary>
        TurnZ = 32,

        /// <summary>The body does not translate, and translation is not computed.</summary>
        Move = MoveX | MoveY | MoveZ,

        /// <summary>The body does not rotate, and rotation is not computed.</summary>
        Turn = TurnX | TurnY | TurnZ,
    }

    /// <summary>The components that locks leave free.</summary>
    internal static class LockedAxes
    {
        /// <summary>A velocity or force without its locked components, world axes.</summary>
        public static Vector3d Moving(this Locks locks, Vector3d v) => Left((int)(locks & Locks.Move), v);

        /// <summary>An angular velocity or torque without its locked components, principal axes.</summary>
        public static Vector3d Turning(this Locks locks, Vector3d v) => Left((int)(locks & Locks.Turn) / (int)Locks.TurnX, v);

        /// <summary>A state without the velocities that locks forbid.</summary>
        public static BodyState Applied(this Locks locks, BodyState body, MassProperties mass)
        {
            body.Velocity = locks.Moving(body.Velocity);
            if ((locks & Locks.Turn) != 0)
            {
                Quaterniond principal = (body.Orientation * mass.PrincipalFrame).Normalized;
                body.AngularVelocity = principal.Rotate(locks.Turning(principal.RotateInverse(body.AngularVelocity)));
            }

            return body;
        }

        /// <summary>The axes of translation that are locked, or those that are free, in words: "x and z".</summary>
        public static string MoveNames(this Locks locks) => Names((int)(locks & Locks.Move));

        /// <summary>The axes of rotation that are locked, or those that are free.</summary>
        public static string TurnNames(this Locks locks) => Names((int)(locks & Locks.Turn) / (int)Locks.TurnX);

        private static Vector3d Left(int locked, Vector3d v) =>
            new Vector3d((locked & 1) != 0 ? 0 : v.X, (locked & 2) != 0 ? 0 : v.Y, (locked & 4) != 0 ? 0 : v.Z);

        private static string Names(int axes) =>
            new[] { string.Empty, "x", "y", "x and y", "z", "x and z", "y and z", "x, y and z" }[axes];
    }
}
