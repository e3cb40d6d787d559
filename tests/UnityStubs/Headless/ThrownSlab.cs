using NUnit.Framework;
using RigidBodyDynamics.Engine;
using UnityEngine;

namespace RigidBodyDynamics.Scripts.Tests.Headless
{
    /// <summary>A slab with ExactRotation, thrown about its middle axis where nothing else acts.</summary>
    public abstract class ThrownSlab
    {
        protected const double Dt = 0.02;
        private static readonly Vector3 Slab = new Vector3(1, 0.4f, 0.1f);
        protected static readonly Vector3 AboutTheMiddleAxis = new Vector3(0.02f, 6, 0.01f);

        /// <summary>The engine's body.</summary>
        protected Rigidbody Body { get; private set; }

        /// <summary>The component on it.</summary>
        protected ExactRotation Exact { get; private set; }

        [SetUp]
        public void Make()
        {
            // a second slab is thrown in the same place
            Touching.IsExpected = true;
            Exact = Thrown(AboutTheMiddleAxis).AddComponent<ExactRotation>();
            Body = Exact.GetComponent<Rigidbody>();
        }

        protected static GameObject Thrown(Vector3 spin)
        {
            GameObject slab = GameObject.CreatePrimitive(PrimitiveType.Cube);
            slab.transform.localScale = Slab;
            Rigidbody body = slab.AddComponent<Rigidbody>();
            body.useGravity = false;
            EngineVersions.SetDrag(body, 0, 0);
            body.angularVelocity = spin;
            return slab;
        }

        protected static void Frames(int count)
        {
            for (int frame = 0; frame < count; frame++)
                Player.Frame(Dt);
        }

        // the free motion of the body from now on
        protected FreeMotion Free() => Free(Body.angularVelocity.Double());

        protected FreeMotion Free(Vector3 spin) => Free(spin.Double());

        protected FreeMotion Free(Vector3d spin) => new FreeMotion(Described(spin));

        protected BodyDescription Described(Vector3d spin) => new BodyDescription("slab", Mass())
        {
            Start = new BodyState(Vector3d.Zero, Body.rotation.Double().Normalized, Vector3d.Zero, spin),
        };

        private MassProperties Mass() => MassProperties.FromPrincipal(1, Body.inertiaTensor.Double(), Quaterniond.Identity, Vector3d.Zero);

        protected double Angle(BodyState expected) => Conserved.AngleBetween(expected.Orientation, Body.rotation.Double().Normalized);
    }
}
