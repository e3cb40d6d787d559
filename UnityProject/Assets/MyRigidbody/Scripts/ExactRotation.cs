using System;
using System.Collections;
using UnityEngine;

namespace RigidBodyDynamics.Scripts
{
    /// <summary>
    /// Gives an ordinary Rigidbody its gyroscopic term: Unity rotates a body with constant angular velocity, whatever its shape, so a
    /// thrown racket does not flip there. The engine still moves the body, with its contacts, joints and other scripts' torques.
    /// </summary>
    /// <remarks>
    /// Between two steps <c>Rigidbody.angularVelocity</c> is the true one, and may be set. During the engine's step it is the mean over
    /// the step, which takes the body to the orientation of the exact rotation; OnCollision messages see that mean.
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

        /// <summary>False where the engine's own motion is right: the body sleeps or soon will, is kinematic, or has no gyroscopic term.</summary>
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
            // the Rigidbody may be destroyed before this component
            if (Body != null)
                Body.maxAngularVelocity = _otherLimit;
        }

        private void FixedUpdate()
        {
            if (EngineVersions.StepsPhysicsItself)
                BeforeSimulate(Time.fixedDeltaTime);
        }

        /// <summary>Called before Physics.Simulate, by a program that steps physics itself.</summary>
        /// <param name="step">The argument of Simulate, s.</param>
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

        /// <summary>Called after Physics.Simulate, by a program that steps physics itself.</summary>
        public void AfterSimulate() => Give(_top.After(Seen()));

        // Unity continues it after each step of its physics and the messages about collisions
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
