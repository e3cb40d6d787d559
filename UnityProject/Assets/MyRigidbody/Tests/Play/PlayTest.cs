using System;
using System.Collections.Generic;
using NUnit.Framework;
using UnityEngine;

namespace RigidBodyDynamics.Scripts.Tests.Play
{
    /// <summary>A test that creates objects while the game plays, and destroys them afterwards.</summary>
    public abstract class PlayTest
    {
        private readonly List<GameObject> _made = new List<GameObject>();

        /// <summary>The step length, as the component gives it to the library.</summary>
        protected static double StepLength => ToUnity.Meant(Time.fixedDeltaTime);

        [TearDown]
        public void LeaveNothingBehind()
        {
            LabInput.LetGo();
            Time.timeScale = 1;
            foreach (GameObject made in _made)
                UnityEngine.Object.DestroyImmediate(made);

            _made.Clear();
        }

        /// <summary>Has objects destroyed after the test.</summary>
        protected void DestroyAfterwards(params GameObject[] objects) => _made.AddRange(objects);

        /// <summary>A cube with a mesh and a script whose fields are set before it wakes.</summary>
        protected T Make<T>(Action<T> set = null, Action<GameObject> prepare = null) where T : Component
        {
            GameObject cube = GameObject.CreatePrimitive(PrimitiveType.Cube);
            DestroyAfterwards(cube);
            cube.SetActive(false);
            prepare?.Invoke(cube);
            // it would collide with the engine's bodies
            if (cube.GetComponent<Rigidbody>() == null)
                UnityEngine.Object.DestroyImmediate(cube.GetComponent<Collider>());

            T script = cube.AddComponent<T>();
            set?.Invoke(script);
            cube.SetActive(true);
            return script;
        }

        /// <summary>A cube that only the test steps: it is disabled, so it gets no FixedUpdate.</summary>
        protected MyRigidbody MakeStill(Action<MyRigidbody> set = null, Action<GameObject> prepare = null)
        {
            MyRigidbody body = Make(set, prepare);
            body.enabled = false;
            return body;
        }

        /// <summary>Unity's body as in the course: without gravity.</summary>
        protected DefaultRigidbody MakeDefault(Action<DefaultRigidbody> set = null) =>
            Make(set, cube => cube.AddComponent<Rigidbody>().useGravity = false);

        /// <summary>The keys of a test: each is held for some of ten seconds, and some together.</summary>
        protected static bool Holds(LabKey key, int step)
        {
            switch (key)
            {
                case LabKey.RightArrow: return step < 100;
                case LabKey.UpArrow: return step >= 50 && step < 150;
                case LabKey.LeftArrow: return step >= 200 && step < 240;
                case LabKey.DownArrow: return step >= 230 && step < 300;
                default: return step >= 75 && step < 400;
            }
        }

        /// <summary>Holds on the screen the keys of a step.</summary>
        protected static void HoldKeys(int step)
        {
            for (LabKey key = LabKey.LeftArrow; key <= LabKey.R; key++)
                LabInput.HoldOnScreen(key, Holds(key, step));
        }

        /// <summary>Holds the keys of a step for the library.</summary>
        protected static void HoldKeys(LabKeyboard keyboard, int step)
        {
            for (LabKey key = LabKey.LeftArrow; key <= LabKey.R; key++)
                keyboard[key] = Holds(key, step);
        }

        /// <summary>All bits of a state.</summary>
        protected static double[] Numbers(BodyState state) => new[]
        {
            state.Position.X, state.Position.Y, state.Position.Z,
            state.Orientation.W, state.Orientation.X, state.Orientation.Y, state.Orientation.Z,
            state.Velocity.X, state.Velocity.Y, state.Velocity.Z,
            state.AngularVelocity.X, state.AngularVelocity.Y, state.AngularVelocity.Z,
        };
    }
}
