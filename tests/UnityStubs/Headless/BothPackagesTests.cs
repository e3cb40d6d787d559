using System.IO;
using System.Linq;
using NUnit.Framework;
using RigidBodyDynamics.Engine;
using UnityEngine;

namespace RigidBodyDynamics.Scripts.Tests.Headless
{
    /// <summary>The full package and the starter in one project: each uses its own classes, and the panel shows both.</summary>
    public sealed class BothPackagesTests
    {
#if !ENABLE_LEGACY_INPUT_MANAGER
        // the sheet's script asks Unity's Input, which such a project refuses: it does not move, and the panel goes on
        [SetUp]
        public void ProjectHasNoInput() => UnityConsole.IgnoresErrors = true;
#endif

        [TearDown]
        public void LetGo() => LabInput.LetGo();

        [Test]
        public void Students_script_in_the_scene_of_the_full_package_is_shown_beside_the_bodies_of_its_own_size()
        {
            Experiment experiment = Laboratory.Load("Lab");
            AddStudents("Student's cube", Vector3.one);
            AddStudents("Student's box", new Vector3(1, 2, 3));
            Frames(5);

            Assert.That(experiment.Mine.Select(body => body.name), Is.EquivalentTo(new[] { "My cube", "My box" }));
            Assert.That(experiment.Students.Select(body => body.Name), Is.EqualTo(new[] { "Student's cube", "Student's box" }));
            Assert.That(experiment.Students.Select(body => body.Mine.name), Is.EqualTo(new[] { "My cube", "My box" }));
            Assert.That(experiment.Students.Select(body => body.Theirs.name), Is.EqualTo(new[] { "Default cube", "Default box" }));
            Assert.That(Gui.Texts, Has.Member("— Student's cube —").And.Member("to My box").And.Member("to Default box"));
            Assert.That(UnityConsole.Fault(), Is.Null);
        }

        [TestCase("Starter")]
        [TestCase("StarterBox")]
        public void Experiment_in_a_scene_of_the_starter_shows_and_records_the_students_body(string scene)
        {
            UnityEngine.SceneManagement.SceneManager.LoadScene(scene);
            World.LoadIfDue();
            Experiment experiment = new GameObject("Experiment").AddComponent<Panel>().GetComponent<Experiment>();
            Frames(2);
            Assert.That(Gui.Texts, Has.Member("— MyRigidbody —"));
            Assert.That(experiment.Mine.Count + experiment.Theirs.Count, Is.Zero);

            Gui.Click("record");
            Frames(5);
            Gui.Click("stop");
            Assert.That(File.ReadAllText(experiment.LastRecording), Does.Contain("\"schema\": \"lab-script/1\"").And.Contain("\"steps\": 5,"));
            Assert.That(File.ReadAllLines(Path.ChangeExtension(experiment.LastRecording, ".csv")), Has.Length.EqualTo(7));
            Assert.That(UnityConsole.Fault(), Is.Null);
        }

        [Test]
        public void Script_that_is_gone_is_shown_no_more()
        {
            Experiment experiment = Laboratory.Build();
            GameObject cube = AddStudents("Student's cube", Vector3.one);
            Frames(2);
            Object.DestroyImmediate(cube);
            Frames(2);
            experiment.StartAgain();
            experiment.Record();
            Frames(2);
            experiment.EndRecording();

            Assert.That(Gui.Texts, Has.No.Member("— Student's cube —"));
            Assert.That(UnityConsole.Fault(), Is.Null);
        }

        private static GameObject AddStudents(string name, Vector3 edges)
        {
            GameObject body = GameObject.CreatePrimitive(PrimitiveType.Cube);
            body.name = name;
            body.transform.localScale = edges;
            body.AddComponent<global::MyRigidbody>();
            return body;
        }

        private static void Frames(int count)
        {
            for (int i = 0; i < count; i++)
                Player.Frame(0.02);
        }
    }
}
