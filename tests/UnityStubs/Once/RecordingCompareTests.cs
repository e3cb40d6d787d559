using System.Diagnostics;
using System.IO;
using NUnit.Framework;
using RigidBodyDynamics.Engine;
using UnityEngine;

namespace RigidBodyDynamics.Scripts.Tests.Headless
{
    /// <summary>The command line reads what the recorder writes.</summary>
    public sealed class RecordingCompareTests
    {
        [TearDown]
        public void LetGo() => LabInput.LetGo();

        [TestCase(false)]
        [TestCase(true)]
        public void Compare_repeats_a_recording_bit_for_bit(bool pushesInUpdate)
        {
            Experiment experiment = Laboratory.Build();
            DefaultRigidbody body = experiment.Theirs[0];
            body.pushesInUpdate = pushesInUpdate;
            experiment.Record();
            Laboratory.Play(frame => 1.0 / 144, 700, () => { });
            Assert.That(body.State.Position.Length, Is.GreaterThan(1));
            experiment.EndRecording();

            string output = Compare(experiment.LastRecording, out int exitCode);

            Assert.That(exitCode, Is.Zero, output);
            Assert.That(output, Does.Contain("bit for bit"));
        }

        [Test]
        public void Compare_finds_a_push_that_was_not_recorded()
        {
            Experiment experiment = Laboratory.Build();
            experiment.Record();
            Laboratory.Play(frame => 0.02f, 50, () => { });
            experiment.Theirs[0].GetComponent<Rigidbody>().AddForce(new Vector3(0, 0, 50));
            Laboratory.Play(frame => 0.02f, 50, () => { });
            experiment.EndRecording();

            string output = Compare(experiment.LastRecording, out int exitCode);

            Assert.That(exitCode, Is.EqualTo(1), output);
            Assert.That(output, Does.Contain("step 51"));
        }

        /// <summary>The command line's output for a recording.</summary>
        internal static string Compare(string recording, out int exitCode)
        {
            ProcessStartInfo start = new ProcessStartInfo("dotnet") { RedirectStandardOutput = true, WorkingDirectory = World.Folder };
            foreach (string argument in new[] { Path.Combine(TestContext.CurrentContext.TestDirectory, "MyRigidbody.Lab.dll"), "compare", recording })
                start.ArgumentList.Add(argument);

            using (Process lab = Process.Start(start))
            {
                string output = lab.StandardOutput.ReadToEnd();
                lab.WaitForExit();
                exitCode = lab.ExitCode;
                return output;
            }
        }
    }
}
