using NUnit.Framework;
using RigidBodyDynamics.Engine;
using UnityEngine;

namespace RigidBodyDynamics.Scripts.Tests.Headless
{
    /// <summary>The panel's numbers for the error and the cost of an integrator.</summary>
    public sealed class YardstickTests
    {
        [TestCase("Exact", 0, 1e-9)]
        [TestCase("RungeKutta4", 1e-9, 1e-3)]
        [TestCase("LabEuler", 0.1, 3.2)]
        public void The_error_is_that_of_the_integrator(string integrator, double least, double most)
        {
            MyRigidbody body = Spinning(integrator);
            Yardstick yardstick = new Yardstick(body);
            yardstick.Follow();
            for (int step = 0; step < 200; step++)
            {
                Player.Frame(0.02f);
                yardstick.Follow();
            }

            Assert.That(yardstick.AngleError, Is.InRange(least, most));
            Assert.That(yardstick.DistanceError, Is.LessThan(1e-9));
        }

        [Test]
        public void Taking_the_time_leaves_the_body_where_it_is()
        {
            MyRigidbody body = Spinning("Exact");
            Yardstick yardstick = new Yardstick(body);
            Player.Frame(0.02f);
            double[] before = Laboratory.Numbers(body.State);

            yardstick.TakeTime();

            Assert.That(yardstick.NanosecondsPerStep, Is.GreaterThan(0));
            Assert.That(Laboratory.Numbers(body.State), Is.EqualTo(before));
        }

        private static MyRigidbody Spinning(string integrator)
        {
            GameObject box = new GameObject("box");
            box.SetActive(false);
            box.transform.localScale = new Vector3(1, 2, 3);
            MyRigidbody body = box.AddComponent<MyRigidbody>();
            body.integrator = integrator;
            body.damping = DampingKind.None;
            body.startSpin = new Vector3(1, 2, 3);
            box.SetActive(true);
            return body;
        }
    }
}
