using System.Collections;
using System.Collections.Generic;
using NUnit.Framework;
using UnityEngine;
using UnityEngine.TestTools;

namespace RigidBodyDynamics.Scripts.Tests.Play
{
    /// <summary>Pause, one step, slow motion, and back to the start.</summary>
    public sealed class ExperimentTests : PlayTest
    {
        [UnityTest]
        public IEnumerator While_paused_nothing_moves()
        {
            MyRigidbody mine = Make<MyRigidbody>(b => b.startVelocity = Vector3.right);
            DefaultRigidbody theirs = MakeDefault(b => b.startVelocity = Vector3.up);
            Experiment experiment = Make<Experiment>();
            yield return new WaitForFixedUpdate();

            experiment.IsPaused = true;
            double[] before = Numbers(mine.State), beforeTheirs = Numbers(theirs.State);
            int steps = experiment.Steps;
            for (int frame = 0; frame < 10; frame++)
                yield return null;

            Assert.That(Numbers(mine.State), Is.EqualTo(before));
            Assert.That(Numbers(theirs.State), Is.EqualTo(beforeTheirs));
            Assert.That(experiment.Steps, Is.EqualTo(steps));

            experiment.IsPaused = false;
            yield return new WaitForFixedUpdate();
            Assert.That(Numbers(mine.State), Is.Not.EqualTo(before));
            Assert.That(Numbers(theirs.State), Is.Not.EqualTo(beforeTheirs));
        }

        [UnityTest]
        public IEnumerator One_step_moves_all_bodies_by_exactly_one()
        {
            MyRigidbody mine = Make<MyRigidbody>(b => b.damping = DampingKind.None);
            DefaultRigidbody theirs = MakeDefault();
            Experiment experiment = Make<Experiment>();
            experiment.IsPaused = true;
            yield return null;
            LabInput.HoldOnScreen(LabKey.RightArrow, true);

            experiment.StepOnce();
            experiment.StepOnce();
            yield return null;

            // v ← v + Δt 5 N / 1 kg, then x ← x + Δt v, by both integrators
            double speed = 5 * StepLength, place = 3 * speed * StepLength;
            Assert.That(experiment.Steps, Is.EqualTo(2));
            Assert.That(experiment.Seconds, Is.EqualTo(2 * StepLength));
            Assert.That(mine.State.Velocity.X, Is.EqualTo(2 * speed).Within(1e-15));
            Assert.That(mine.State.Position.X, Is.EqualTo(place).Within(1e-15));
            Assert.That(theirs.State.Velocity.X, Is.EqualTo(2 * speed).Within(1e-6));
            Assert.That(theirs.State.Position.X, Is.EqualTo(place).Within(1e-6));
            Assert.That(theirs.transform.position.x, Is.EqualTo(place).Within(1e-6));
        }

        [Test]
        public void Reset_brings_back_the_start_and_the_same_keys_the_same_motion()
        {
            MyRigidbody mine = MakeStill(b => b.startSpin = new Vector3(1, 2, 3), cube => cube.transform.position = new Vector3(0.1f, 0.2f, 0.3f));
            Experiment experiment = Make<Experiment>();
            double[] start = Numbers(mine.State);
            List<double[]> first = Motion(mine);

            experiment.StartAgain();

            Assert.That(Numbers(mine.State), Is.EqualTo(start));
            Assert.That(mine.transform.position.Equals(new Vector3(0.1f, 0.2f, 0.3f)), Is.True);
            Assert.That(experiment.Steps, Is.Zero);
            Assert.That(Motion(mine), Is.EqualTo(first));
        }

        [UnityTest]
        public IEnumerator Reset_brings_back_the_start_of_the_engines_body()
        {
            DefaultRigidbody theirs = MakeDefault(b => b.startSpin = new Vector3(1, 2, 3));
            Experiment experiment = Make<Experiment>();
            LabInput.HoldOnScreen(LabKey.UpArrow, true);
            for (int step = 0; step < 5; step++)
                yield return new WaitForFixedUpdate();

            Assert.That(theirs.State.Position.Y, Is.GreaterThan(0));
            experiment.StartAgain();

            Assert.That(theirs.State.Position.Length, Is.Zero);
            Assert.That(theirs.State.Velocity.Length, Is.Zero);
            Assert.That(theirs.State.AngularVelocity.Y, Is.EqualTo(2).Within(1e-6));
        }

        [UnityTest]
        public IEnumerator Slow_motion_has_the_same_states()
        {
            Experiment experiment = Make<Experiment>();
            MyRigidbody reference = MakeStill(Spinning);
            experiment.IsSlow = true;
            yield return new WaitForFixedUpdate();
            MyRigidbody mine = Make<MyRigidbody>(Spinning);
            for (int step = 0; step < 5; step++)
            {
                yield return new WaitForFixedUpdate();
                reference.Step();
                Assert.That(Numbers(mine.State), Is.EqualTo(Numbers(reference.State)), "step " + step);
            }

            Assert.That(Time.timeScale, Is.LessThan(1));
        }

        private static void Spinning(MyRigidbody body) => body.startSpin = new Vector3(1, 2, 3);

        private static List<double[]> Motion(MyRigidbody body)
        {
            List<double[]> states = new List<double[]>();
            for (int step = 0; step < 500; step++)
            {
                HoldKeys(step);
                body.Step();
                states.Add(Numbers(body.State));
            }

            return states;
        }
    }
}
