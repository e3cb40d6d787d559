using System.Collections;
using NUnit.Framework;
using UnityEngine;
using UnityEngine.TestTools;

namespace RigidBodyDynamics.Scripts.Tests.Play
{
    /// <summary>A step of the component is a step of the library.</summary>
    public sealed class StepTests : PlayTest
    {
        private static readonly Vector3 Place = new Vector3(0.3f, -1.7f, 2.9f), Size = new Vector3(1, 2, 3);
        private static readonly Vector3 Velocity = new Vector3(0.1f, 0.2f, -0.3f), Spin = new Vector3(0.7f, -1.1f, 0.4f);
        private static readonly Quaternion Turned = Quaternion.AngleAxis(40, new Vector3(1, 2, 2));

        [TestCase("LabEuler")]
        [TestCase("Exact")]
        [TestCase("RungeKutta4")]
        [TestCase("UnityRigidbody")]
        public void Five_hundred_steps_with_keys_are_those_of_the_library_to_the_bit(string integrator)
        {
            MyRigidbody body = MakeStill(b => Set(b, integrator), Put);
            LabKeyboard keyboard = new LabKeyboard();
            Simulation library = Library(integrator, keyboard);
            Assert.That(Numbers(body.State), Is.EqualTo(Numbers(library.Bodies[0].State)));

            for (int step = 0; step < 500; step++)
            {
                HoldKeys(step);
                HoldKeys(keyboard, step);
                body.Step();
                library.Step();
                Assert.That(Numbers(body.State), Is.EqualTo(Numbers(library.Bodies[0].State)), "step " + step);
            }
        }

        [Test]
        public void The_transform_is_the_state_rounded_to_float()
        {
            MyRigidbody body = MakeStill(b => Set(b, "Exact"), Put);
            for (int step = 0; step < 500; step++)
            {
                HoldKeys(step);
                body.Step();
                Vector3d place = body.State.Position;
                Quaterniond turn = body.State.Orientation;
                Assert.That(body.transform.position.Equals(new Vector3((float)place.X, (float)place.Y, (float)place.Z)), Is.True, "step " + step);

                // the engine may scale a rotation to length one, which changes a last bit
                Quaternion shown = body.transform.rotation;
                Assert.That(new[] { shown.w, shown.x, shown.y, shown.z }, Is.EqualTo(new[] { turn.W, turn.X, turn.Y, turn.Z }).Within(1.2e-7));
            }
        }

        [UnityTest]
        public IEnumerator Every_fixed_step_is_one_step()
        {
            yield return new WaitForFixedUpdate();
            MyRigidbody body = Make<MyRigidbody>(b => Set(b, "LabEuler"), Put);
            Simulation library = Library("LabEuler", new LabKeyboard());
            for (int step = 0; step < 10; step++)
            {
                yield return new WaitForFixedUpdate();
                library.Step();
                Assert.That(Numbers(body.State), Is.EqualTo(Numbers(library.Bodies[0].State)), "step " + step);
            }
        }

        private static void Set(MyRigidbody body, string integrator)
        {
            body.integrator = integrator;
            body.mass = 1.5;
            body.startVelocity = Velocity;
            body.startSpin = Spin;
        }

        private static void Put(GameObject cube)
        {
            cube.transform.position = Place;
            cube.transform.rotation = Turned;
            cube.transform.localScale = Size;
        }

        // written out separately, so that the component is not compared with itself
        private static Simulation Library(string integrator, LabKeyboard keyboard)
        {
            BodyDescription body = new BodyDescription("box", PointMasses.BoxVertices(1.5, new Vector3d(1, 2, 3)))
            {
                Rule = Rules.Named(integrator),
                Start = new BodyState(
                    new Vector3d(Place.x, Place.y, Place.z),
                    new Quaterniond(Turned.w, Turned.x, Turned.y, Turned.z),
                    new Vector3d(Velocity.x, Velocity.y, Velocity.z),
                    new Vector3d(Spin.x, Spin.y, Spin.z)),
            };
            return new Simulation(TimeSteps.Every(StepLength), body.With(new DecayPerStep(0.98, 0.98)).With(new HeldKeys(keyboard)));
        }
    }
}
