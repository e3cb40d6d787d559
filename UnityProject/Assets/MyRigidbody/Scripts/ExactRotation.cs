using System;
using System.Collections;
using UnityEngine;

namespace RigidBodyDynamics.Scripts
{
    /// <summary>
    /// Makes an ordinary Rigidbody tumble as it should: Unity turns a body by a constant angular velocity, whatever its shape, and so
    /// no racket of Unity's ever flips. The engine still moves it; contacts, joints and other scripts' torques are the engine's.
    /// </summary>
    /// <remarks>
    /// Between two steps <c>Rigidbody.angularVelocity</c> is the true one, and may be set. While the engine steps it is the mean over
    /// the step, which takes the body to where the exact rotation is afterwards; OnCollision messages see that.
    /// </remarks>
    [DisallowMultipleComponent]
    [RequireComponent(typeof(Rigidbody))]
    [DefaultExecutionOrder(AfterOtherScripts)]
    [AddComponentMenu("MyRigidbody/Exact Rotation")]
    public sealed class ExactRotation : MonoBehaviour
    {
        private const int AfterOtherScripts = 32000;
        private static readonly WaitForFixedUpdate PhysicsIsDone = new WaitForFixedUpdate();

        [Tooltip("Rigidbody.maxAngularVelocity while this is on, rad/s. Unity's own limit is 7, and a body that reaches it loses what is above.\n启用期间 Rigidbody 的最大角速度，弧度每秒。Unity 默认限制为 7，超出部分会被截去。")]
        public float maxAngularVelocity = 1000;

        private readonly ExactTop _top = new ExactTop();
        private Rigidbody _body;
        private float _otherLimit;
        private Coroutine _watch;

        /// <summary>False while the engine's own motion is left alone: the body sleeps or soon will, is kinematic, or its shape needs nothing.</summary>
        public bool IsTurning => isActiveAndEnabled && _top.IsFollowing;

        /// <summary>ω after the last step, rad/s, world axes.</summary>
        public Vector3d AngularVelocity => IsTurning ? _top.State.AngularVelocity : Body.angularVelocity.Double();

        /// <summary>Takes body axes to world axes.</summary>
        public Quaterniond Orientation => IsTurning ? _top.State.Orientation : Body.rotation.Double().Normalized;

        /// <summary>L about the centre of mass, kg m²/s, world axes.</summary>
        public Vector3d AngularMomentum => Conserved.AngularMomentum(Turning, Inertia);

        /// <summary>½ ω·L, J.</summary>
        public double RotationalEnergy => 0.5 * Vector3d.Dot(AngularVelocity, AngularMomentum);

        private BodyState Turning => new BodyState(Vector3d.Zero, Orientation, Vector3d.Zero, AngularVelocity);

        private MassProperties Inertia => Seen().MassProperties(out _);

        private Rigidbody Body => _body != null ? _body : _body = GetComponent<Rigidbody>();

        private void OnEnable()
        {
            _otherLimit = Body.maxAngularVelocity;
            _watch = StartCoroutine(Watch());
        }

        private void OnDisable()
        {
            if (_watch != null)
                StopCoroutine(_watch);

            _top.Forget();
            // with the object the Rigidbody may be gone already
            if (Body != null)
                Body.maxAngularVelocity = _otherLimit;
        }

        private void FixedUpdate()
        {
            if (EngineVersions.StepsPhysicsItself)
                BeforeSimulate(Time.fixedDeltaTime);
        }

        /// <summary>To be called before Physics.Simulate, by a program that steps physics itself.</summary>
        /// <param name="step">What it will call it with, s.</param>
        public void BeforeSimulate(float step)
        {
            if (Body.maxAngularVelocity != maxAngularVelocity)
                Body.maxAngularVelocity = maxAngularVelocity;

            try
            {
                Give(_top.Before(Seen(), step));
            }
            catch (ArgumentException impossible)
            {
                Debug.LogError("ExactRotation on '" + name + "': " + impossible.Message, this);
                enabled = false;
            }
        }

        /// <summary>To be called after Physics.Simulate, by a program that steps physics itself.</summary>
        public void AfterSimulate() => Give(_top.After(Seen()));

        // Unity goes on with it after each step of its physics, once collisions have been told of
        private IEnumerator Watch()
        {
            while (true)
            {
                yield return PhysicsIsDone;
                if (enabled)
                    AfterSimulate();
            }
        }

        private void Give(Vector3d? angularVelocity)
        {
            if (angularVelocity != null)
                Body.angularVelocity = angularVelocity.Value.Float();
        }

        private EngineBody Seen() => new EngineBody
        {
            Orientation = Body.rotation.Double(),
            AngularVelocity = Body.angularVelocity.Double(),
            Velocity = EngineVersions.Velocity(Body).Double(),
            Mass = Body.mass,
            InertiaTensor = Body.inertiaTensor.Double(),
            InertiaTensorRotation = Body.inertiaTensorRotation.Double(),
            AngularDrag = EngineVersions.AngularDrag(Body),
            SleepThreshold = Body.sleepThreshold,
            IsAsleep = Body.isKinematic || Body.IsSleeping(),
        };
    }
}
