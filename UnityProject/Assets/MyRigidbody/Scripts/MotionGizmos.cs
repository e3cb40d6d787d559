using UnityEngine;

namespace RigidBodyDynamics.Scripts
{
    /// <summary>
    /// Draws the angular velocity (yellow), the angular momentum (magenta) and the principal axes (red, green, blue; the longer, the
    /// smaller the moment) of a body. Visible in the Scene view, and in the Game view while "Gizmos" is on.
    /// </summary>
    [RequireComponent(typeof(MyRigidbody))]
    [AddComponentMenu("MyRigidbody/Motion Gizmos")]
    public sealed class MotionGizmos : MonoBehaviour
    {
        [Tooltip("Length in m of an angular velocity of 1 rad/s.\n1 弧度每秒的角速度画成多少米。")]
        public float spinLength = 0.3f;

        [Tooltip("Length in m of an angular momentum of 1 kg m²/s.\n1 千克平方米每秒的角动量画成多少米。")]
        public float momentumLength = 0.3f;

        private void OnDrawGizmos()
        {
            MyRigidbody mine = GetComponent<MyRigidbody>();
            if (!mine.IsReady)
                return;

            MassProperties mass = mine.Body.Mass;
            BodyState state = mine.State;
            Vector3 center = transform.position + state.Orientation.Rotate(mass.CenterOfMass).Float();
            Draw(Color.yellow, center, spinLength * state.AngularVelocity.Float());
            Draw(Color.magenta, center, momentumLength * mine.Body.AngularMomentum.Float());

            Quaterniond axes = state.Orientation * mass.PrincipalFrame;
            Vector3d moments = mass.PrincipalMoments;
            Draw(Color.red, center, Axis(axes, new Vector3d(1, 0, 0), moments.X, mass.Mass));
            Draw(Color.green, center, Axis(axes, new Vector3d(0, 1, 0), moments.Y, mass.Mass));
            Draw(Color.blue, center, Axis(axes, new Vector3d(0, 0, 1), moments.Z, mass.Mass));
        }

        // the ellipsoid of inertia has half axes 1 / √I; scaled here by the mass, to the size of the object
        private static Vector3 Axis(Quaterniond axes, Vector3d axis, double moment, double mass) =>
            Mathf.Sqrt((float)(mass / moment)) * 0.5f * axes.Rotate(axis).Float();

        private static void Draw(Color color, Vector3 from, Vector3 along)
        {
            Gizmos.color = color;
            Gizmos.DrawRay(from, along);
            Gizmos.DrawSphere(from + along, 0.03f);
        }
    }
}
