using System;
using System.Linq;
using RigidBodyDynamics.Engine;
using UnityEngine;
using UnityEngine.SceneManagement;

namespace RigidBodyDynamics.Scripts.Tests.Headless
{
    /// <summary>Sets up an experiment, in code or from a scene of the project, and plays it with the same keys by time.</summary>
    internal static class Laboratory
    {
        /// <summary>A cube of each kind, the experiment and the panel.</summary>
        public static Experiment Build()
        {
            MyRigidbody mine = Cube("My cube").AddComponent<MyRigidbody>();
            GameObject cube = Cube("Default cube");
            cube.AddComponent<Rigidbody>().useGravity = false;
            mine.comparedWith = cube.AddComponent<DefaultRigidbody>();
            return new GameObject("Experiment").AddComponent<Panel>().GetComponent<Experiment>();
        }

        /// <summary>Loads a scene of the project.</summary>
        public static Experiment Load(string scene)
        {
            SceneManager.LoadScene(scene);
            World.LoadIfDue();
            return SceneManager.GetActiveScene().GetRootGameObjects().Select(root => root.GetComponent<Experiment>()).Single(found => found != null);
        }

        /// <summary>Plays a number of fixed steps, in frames of any length, and calls a function after each step.</summary>
        public static void Play(Func<int, double> frameLength, int steps, Action look)
        {
            int done = 0;
            for (int frame = 0; done < steps; frame++)
            {
                foreach (Moment moment in Player.Moments(frameLength(frame), HoldKeys))
                {
                    if (moment == Moment.AfterFixedStep && done++ < steps)
                        look();
                }
            }
        }

        /// <summary>Every number of a state.</summary>
        public static double[] Numbers(BodyState s) => new[]
        {
            s.Position.X, s.Position.Y, s.Position.Z, s.Orientation.W, s.Orientation.X, s.Orientation.Y, s.Orientation.Z,
            s.Velocity.X, s.Velocity.Y, s.Velocity.Z, s.AngularVelocity.X, s.AngularVelocity.Y, s.AngularVelocity.Z,
        };

        /// <summary>Keys that are held by the game's time, whenever a script asks: what a frame rate does to a keyboard is left out.</summary>
        public static void HoldKeys()
        {
            float t = Time.time;
            LabInput.HoldOnScreen(LabKey.RightArrow, t < 2.01f);
            LabInput.HoldOnScreen(LabKey.UpArrow, t > 1.01f && t < 3.01f);
            LabInput.HoldOnScreen(LabKey.LeftArrow, t > 4.01f && t < 6.01f);
            LabInput.HoldOnScreen(LabKey.DownArrow, t > 5.01f && t < 5.51f);
            LabInput.HoldOnScreen(LabKey.R, t > 1.51f && t < 8.01f);
        }

        private static GameObject Cube(string name)
        {
            GameObject cube = GameObject.CreatePrimitive(PrimitiveType.Cube);
            cube.name = name;
            return cube;
        }
    }
}
