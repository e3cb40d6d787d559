using System.Collections;
using System.Globalization;
using System.IO;
using System.Linq;
using System.Text.RegularExpressions;
using NUnit.Framework;
using UnityEngine;
using UnityEngine.TestTools;

namespace RigidBodyDynamics.Scripts.Tests.Play
{
    /// <summary>A recording is complete if it can be read back.</summary>
    public sealed class RecordingTests : PlayTest
    {
        private const int Steps = 20;

        [UnityTest]
        public IEnumerator A_recording_has_every_push_and_one_row_more_than_steps()
        {
            string folder = Path.Combine(Application.temporaryCachePath, "recordings");
            DefaultRigidbody body = MakeDefault(b =>
            {
                b.name = "Default \"cube\"";
                b.startSpin = new Vector3(1, 2, 3);
            });
            Experiment experiment = Make<Experiment>();
            yield return new WaitForFixedUpdate();
            LabInput.HoldOnScreen(LabKey.RightArrow, true);
            experiment.Record();
            Assert.That(experiment.IsRecording, Is.True);
            for (int step = 0; step < Steps; step++)
            {
                LabInput.HoldOnScreen(LabKey.R, step >= 10);
                yield return new WaitForFixedUpdate();
            }

            experiment.EndRecording(folder);

            Assert.That(experiment.IsRecording, Is.False);
            string json = File.ReadAllText(experiment.LastRecording);
            string[] rows = File.ReadAllLines(Path.ChangeExtension(experiment.LastRecording, ".csv"));
            Directory.Delete(folder, true);
            IsComplete(json);
            IsComplete(rows, body.State);
        }

        [UnityTest]
        public IEnumerator A_recording_of_a_frozen_body_says_where_it_is_frozen()
        {
            string folder = Path.Combine(Application.temporaryCachePath, "recordings");
            DefaultRigidbody body = MakeDefault();
            body.GetComponent<Rigidbody>().constraints = RigidbodyConstraints.FreezePositionY | RigidbodyConstraints.FreezeRotationX | RigidbodyConstraints.FreezeRotationZ;
            Experiment experiment = Make<Experiment>();
            yield return new WaitForFixedUpdate();
            experiment.Record();
            yield return new WaitForFixedUpdate();
            experiment.EndRecording(folder);
            string json = File.ReadAllText(experiment.LastRecording);
            Directory.Delete(folder, true);

            Assert.That(json, Does.Contain("\"lock\": {\"move\": \"y\", \"turn\": \"xz\"},"));
            // Unity's manual: a frozen axis has a moment of 0
            Assert.That(List(json, "inertiaTensor"), Is.EqualTo(new[] { 0, 1f / 6, 0 }).Within(1e-6f));
            Assert.That(body.Mass.PrincipalMoments.Y, Is.EqualTo(1.0 / 6).Within(1e-6));
        }

        private static void IsComplete(string json)
        {
            float[] force = List(json, "force"), torque = List(json, "torque");
            Assert.That(json, Does.Contain("\"schema\": \"free-rigid-body/1\"").And.Contain("\"steps\": " + Steps + ","));
            Assert.That(List(json, "dt"), Is.EqualTo(Enumerable.Repeat(Time.fixedDeltaTime, Steps)));
            Assert.That(force, Is.EqualTo(Enumerable.Repeat(new[] { 5f, 0, 0 }, Steps).SelectMany(push => push)));
            Assert.That(torque.Length, Is.EqualTo(3 * Steps));
            for (int step = 0; step < Steps; step++)
                Assert.That(torque[3 * step], Is.EqualTo(step < 10 ? 0 : Mathf.Sin(step * Time.fixedDeltaTime)).Within(1e-6f), "step " + step);

            Assert.That(List(json, "angularVelocity"), Is.EqualTo(new[] { 1f, 2, 3 }));
            Assert.That(List(json, "inertiaTensor"), Is.EqualTo(Enumerable.Repeat(1f / 6, 3)).Within(1e-6f));
            Assert.That(List(json, "rotation"), Is.EqualTo(new[] { 0f, 0, 0, 1 }));
        }

        private static void IsComplete(string[] rows, BodyState last)
        {
            Assert.That(rows.Length, Is.EqualTo(1 + Steps + 1));
            string[] names = rows[0].Split(',');
            Assert.That(rows.Select(row => row.Split(',').Length), Is.All.EqualTo(names.Length));
            float[] first = Row(rows[1]), end = Row(rows[rows.Length - 1]);
            Assert.That(first.Skip(2).Take(3), Is.All.Zero);
            Assert.That(end[0], Is.EqualTo(Steps));
            Assert.That(end[1], Is.EqualTo(Steps * Time.fixedDeltaTime).Within(1e-6f));
            Assert.That(end.Skip(2).Take(3), Is.EqualTo(new[] { (float)last.Position.X, (float)last.Position.Y, (float)last.Position.Z }));
            Assert.That(end[9], Is.EqualTo((float)last.Velocity.X));
            Assert.That(end[12], Is.EqualTo((float)last.AngularVelocity.X));
        }

        private static float[] List(string json, string name)
        {
            Match found = Regex.Match(json, "\"" + name + "\": \\[([^\\]]*)\\]");
            Assert.That(found.Success, Is.True, name);
            return Row(found.Groups[1].Value);
        }

        private static float[] Row(string numbers) =>
            numbers.Split(',').Select(number => float.Parse(number, CultureInfo.InvariantCulture)).ToArray();
    }
}
