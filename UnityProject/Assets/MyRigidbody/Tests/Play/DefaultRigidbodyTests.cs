using System;
using System.Collections;
using NUnit.Framework;
using UnityEngine;
using UnityEngine.TestTools;

namespace RigidBodyDynamics.Scripts.Tests.Play
{
    /// <summary>The engine's body moves as the library predicts.</summary>
    public sealed class DefaultRigidbodyTests : PlayTest
    {
        // m, and 1 for each number of the orientation, and both per s. The integrator is the engine's to the bit, but its input is
        // not: the engine computes the box's inertia and the torque's sine in float, and a script cannot see when it sleeps
        private const double Bound = 1e-3; // measured without the engine, where the inertia alone is rounded: below 1e-6

        [UnityTest]
        public IEnumerator It_moves_by_the_librarys_UnityRigidbody() =>
            Compare(b => { }, Solids.Box(1, new Vector3d(1, 1, 1)), new UnitySettings());

        [UnityTest]
        public IEnumerator It_does_so_with_drag_the_labs_inertia_and_without_a_limit() => Compare(
            b =>
            {
                b.drag = b.angularDrag = 1;
                b.hasLabInertia = true;
                b.limitsSpin = false;
            },
            PointMasses.BoxVertices(1, new Vector3d(1, 1, 1)),
            new UnitySettings { Drag = 1, AngularDrag = 1, MaxAngularVelocity = 1e6 });

        [UnityTest]
        public IEnumerator A_torque_turns_the_solid_box_three_times_as_fast()
        {
            DefaultRigidbody solid = MakeDefault();
            DefaultRigidbody lab = MakeDefault(b =>
            {
                b.hasLabInertia = true;
                b.transform.position = new Vector3(10, 0, 0);
            });
            LabInput.HoldOnScreen(LabKey.R, true);
            for (int step = 0; step < 10; step++)
                yield return new WaitForFixedUpdate();

            Assert.That(lab.State.AngularVelocity.X, Is.GreaterThan(0));
            Assert.That(solid.State.AngularVelocity.X / lab.State.AngularVelocity.X, Is.EqualTo(3).Within(1e-3));
        }

        private IEnumerator Compare(Action<DefaultRigidbody> set, MassProperties mass, UnitySettings unity)
        {
            yield return new WaitForFixedUpdate();
            DefaultRigidbody body = MakeDefault(set);
            LabKeyboard keyboard = new LabKeyboard();
            BodyDescription expected = new BodyDescription("cube", mass) { Rule = Rules.UnityRigidbody, Unity = unity };
            Simulation library = new Simulation(TimeSteps.Every(StepLength), expected.With(new HeldKeys(keyboard)));
            for (int step = 0; step < 200; step++)
            {
                HoldKeys(step);
                HoldKeys(keyboard, step);
                yield return new WaitForFixedUpdate();
                library.Step();
                Assert.That(Numbers(body.State), Is.EqualTo(Numbers(library.Bodies[0].State)).Within(Bound), "step " + step);
            }

            Assert.That(body.State.Position.X, Is.GreaterThan(1));
            Assert.That(body.State.AngularVelocity.Length, Is.GreaterThan(0.2));
        }
    }
}
