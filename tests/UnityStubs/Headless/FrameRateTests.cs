using System;
using System.Collections.Generic;
using System.Linq;
using NUnit.Framework;
using RigidBodyDynamics.Engine;

namespace RigidBodyDynamics.Scripts.Tests.Headless
{
    /// <summary>Ten seconds at any frame rate: MyRigidbody is the same to the bit, a body pushed in Update is not.</summary>
    public sealed class FrameRateTests
    {
        private const int TenSeconds = 500;
        private static readonly int[] Rates = { 20, 50, 60, 144, 240 };

        [TearDown]
        public void LetGo() => LabInput.LetGo();

        [TestCase("")]
        [TestCase("Lab")]
        [TestCase("TumblingSlab")]
        public void MyRigidbody_moves_alike_to_the_bit_at_every_frame_rate(string scene)
        {
            List<double[]> expected = Motion(scene, frame => 0.02, false, Mine);
            Assert.That(expected.Last(), Is.Not.EqualTo(expected.First()), "they move");
            foreach (int rate in Rates)
                Assert.That(Motion(scene, frame => 1.0 / rate, false, Mine), Is.EqualTo(expected), rate + " frames a second");

            Assert.That(Motion(scene, Irregular, false, Mine), Is.EqualTo(expected), "irregular frames");
        }

        [TestCase("")]
        [TestCase("Lab")]
        [TestCase("ThrownSlabs")]
        public void So_does_a_DefaultRigidbody_that_is_pushed_in_FixedUpdate(string scene)
        {
            List<double[]> expected = Motion(scene, frame => 0.02, false, Theirs);
            Assert.That(Motion(scene, frame => 1.0 / 144, false, Theirs), Is.EqualTo(expected));
            Assert.That(Motion(scene, Irregular, false, Theirs), Is.EqualTo(expected));
        }

        // what the course's script does: at 240 frames a second the same key pushes 4.8 times as hard as at 50
        [TestCase("")]
        [TestCase("Lab")]
        public void A_DefaultRigidbody_that_is_pushed_in_Update_goes_farther_the_higher_the_frame_rate(string scene)
        {
            double[] speeds = Rates.Select(rate => Motion(scene, frame => 1.0 / rate, true, Theirs)[90][7]).ToArray();

            Assert.That(speeds, Is.Ordered);
            Assert.That(speeds[4] / speeds[1], Is.EqualTo(4.8).Within(0.1));
            Assert.That(speeds[0] / speeds[1], Is.EqualTo(0.4).Within(0.02));
            Assert.That(Motion(scene, Irregular, true, Theirs), Is.Not.EqualTo(Motion(scene, frame => 0.02, true, Theirs)));
        }

        private static IEnumerable<BodyState> Mine(Experiment experiment) => experiment.Mine.Select(body => body.State);

        private static IEnumerable<BodyState> Theirs(Experiment experiment) => experiment.Theirs.Select(body => body.State);

        // a row of numbers for every fixed step, all bodies one after another
        private static List<double[]> Motion(string scene, Func<int, double> frame, bool pushesInUpdate, Func<Experiment, IEnumerable<BodyState>> states)
        {
            World.Begin(isPlaying: true);
            Experiment experiment = scene.Length == 0 ? Laboratory.Build() : Laboratory.Load(scene);
            foreach (DefaultRigidbody body in experiment.Theirs)
                body.pushesInUpdate = pushesInUpdate;

            List<double[]> motion = new List<double[]>();
            Laboratory.Play(frame, TenSeconds, () => motion.Add(states(experiment).SelectMany(Laboratory.Numbers).ToArray()));
            Assert.That(UnityConsole.Fault(), Is.Null);
            return motion;
        }

        // between 1 and 80 ms, by a fixed sequence; one frame in fifty takes half a second
        private static double Irregular(int frame) => frame % 50 == 49 ? 0.5 : 0.001 + 0.079 * (frame * 7919 % 1009 / 1009.0);
    }
}
