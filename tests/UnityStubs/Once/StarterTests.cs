using System;
using System.IO;
using System.Linq;
using System.Reflection;
using System.Text;
using NUnit.Framework;
using RigidBodyDynamics.Engine;
using RigidBodyDynamics.Judging;
using RigidBodyDynamics.Starter;
using UnityEditor;
using UnityEditor.Compilation;
using UnityEngine;

namespace RigidBodyDynamics.Scripts.Tests.Headless
{
    /// <summary>The starter: both cubes of its scenes move as their scripts say, and its window says which step is wrong, and exports the submission.</summary>
    public sealed class StarterTests
    {
        private static readonly string Given = File.ReadAllText(SceneLoader.InProject("Assets/MyRigidbodyStarter/MyRigidbody.cs"));

        /// <summary>A script that takes the five steps as the sheet has them.</summary>
        internal static string Right => Filled(
            "v += force / mass * dt;",
            "Matrix4x4 R = Matrix4x4.Rotate(transform.rotation); w += dt * (R * I_ref * R.transpose).inverse.MultiplyVector(torque);",
            "transform.position += v * dt;",
            "Quaternion q = transform.rotation, d = new Quaternion(w.x * dt / 2, w.y * dt / 2, w.z * dt / 2, 0) * q; transform.rotation = new Quaternion(q.x + d.x, q.y + d.y, q.z + d.z, q.w + d.w).normalized;",
            "v *= 0.98f; w *= 0.98f;");

        [Test]
        public void Starter_is_all_missing_and_nothing_else() =>
            Assert.That(Verdict.FiveSteps.Select(step => Judged(Given)[step]), Has.All.EqualTo(Mark.Missing));

        [Test]
        public void Five_right_steps_are_five_green_lamps()
        {
            Verdict verdict = Judged(Right);
            Assert.That(verdict.Findings.Select(finding => finding.Code), Is.Empty);
            Assert.That(verdict.Outcome, Is.EqualTo(Outcome.Right));
        }

        [TestCase("dt / 2, w.y * dt / 2, w.z * dt / 2", "dt, w.y * dt, w.z * dt", Step.Orientation)]
        [TestCase("R * I_ref * R.transpose", "R * I_ref * R", Step.AngularVelocity)]
        [TestCase("v += force / mass * dt", "v += force * mass * dt", Step.Velocity)]
        [TestCase("w *= 0.98f", "w *= 0.9f", Step.Damping)]
        [TestCase("position += v * dt", "position += v", Step.Position)]
        public void A_wrong_step_is_the_one_that_is_off(string right, string wrong, Step step)
        {
            Assert.That(Right, Does.Contain(right));
            Verdict verdict = Judged(Right.Replace(right, wrong));
            Assert.That(Verdict.FiveSteps.Where(other => verdict[other] != Mark.Right), Is.EqualTo(new[] { step }));
        }

        [Test]
        public void Window_shows_five_lamps_and_not_how_to_mend_them()
        {
            CheckWindow window = EditorWindow.GetWindow<CheckWindow>("x");
            Gui.Click(window, window.OnGUI, "检查五个步骤 Check my five steps");
            Gui.Draw(window, window.OnGUI);
            Assert.That(Gui.Texts.Count(text => text.StartsWith("●", StringComparison.Ordinal)), Is.EqualTo(5));
            Assert.That(Gui.Texts.Where(text => text.StartsWith("●", StringComparison.Ordinal)), Has.All.EndsWith("未完成 missing"));
            Assert.That(window.Verdict.Findings.Select(finding => finding.English).Where(help => Gui.Texts.Any(text => text.Contains(help))), Is.Empty);
        }

        [Test]
        public void Package_that_is_handed_in_has_number_and_name_and_the_script_and_no_window()
        {
            CheckWindow window = EditorWindow.GetWindow<CheckWindow>("x");
            Gui.Type("学号 student number", " 210840007 ");
            Gui.Draw(window, window.OnGUI);
            Gui.Type("姓名 name", "学生一");
            Gui.Draw(window, window.OnGUI);
            Gui.Click(window, window.OnGUI, "导出 210840007_学生一.unitypackage");
            Assert.That(AssetDatabase.Exported.File, Is.EqualTo("210840007_学生一.unitypackage"));
            Assert.That(AssetDatabase.Exported.Assets, Does.Contain("Assets/MyRigidbodyStarter/MyRigidbody.cs").And.Contain("Assets/MyRigidbodyStarter/Scenes/Starter.unity"));
            Assert.That(AssetDatabase.Exported.Assets, Has.None.Contains("/Editor"));
            Assert.That(EditorUtility.Shown, Is.EqualTo(AssetDatabase.Exported.File));
        }

        [TestCase("", "学生一")]
        [TestCase("1", " ")]
        [TestCase("1/2", "a")]
        [TestCase("1", "a:b")]
        [TestCase("1_2", "a")]
        public void Names_that_no_file_may_have_make_no_package(string number, string name) => Assert.That(Handout.PackageName(number, name), Is.Null);

        [TestCase("Starter", 1f)]
        [TestCase("StarterBox", 2f)]
        public void Scene_has_the_students_body_beside_Unitys_and_the_keys_move_Unitys(string scene, float height)
        {
            World.Begin(isPlaying: true);
            UnityEngine.SceneManagement.SceneManager.LoadScene(scene);
            World.LoadIfDue();
            GameObject mine = GameObject.Find("MyRigidbody"), theirs = GameObject.Find("DefaultRigidbody");
            Assert.That(mine.GetComponent<global::MyRigidbody>(), Is.Not.Null);
            for (int i = 0; i < 50; i++)
            {
                Engine.Keys.Hold(KeyCode.RightArrow, true);
                Player.Frame(0.02);
            }

            Assert.That(theirs.transform.position.x - 2.5f, Is.EqualTo(2.5f).Within(0.06f)); // a t²/2; the engine moves with the new velocity
            Assert.That(mine.transform.position.x, Is.EqualTo(-2.5f));
            Mesh mesh = mine.GetComponent<MeshFilter>().mesh;
            Assert.That(mesh.bounds.size.y * mine.transform.localScale.y, Is.EqualTo(height));
            Assert.That(mine.transform.localScale, Is.EqualTo(Vector3.one));
        }

        private static string Filled(params string[] steps)
        {
            string script = Given;
            foreach (string step in steps)
            {
                int todo = script.IndexOf("// TODO", StringComparison.Ordinal), end = script.IndexOf('\n', todo);
                script = script.Substring(0, todo) + step + script.Substring(end);
            }

            return script;
        }

        // compiled and played as the window does it
        private static Verdict Judged(string script)
        {
            string folder = Path.Combine(Path.GetTempPath(), "starter-" + Guid.NewGuid().ToString("N"));
            Directory.CreateDirectory(folder);
            try
            {
                string path = Path.Combine(folder, "MyRigidbody.cs"), failure = null;
                File.WriteAllText(path, script, new UTF8Encoding(true));
                World.Begin(isPlaying: false);
                Verdict verdict = null;
                ScriptBuild.Begin(
                    path,
                    (assembly, type) =>
                    {
                        using (EditorLaboratory laboratory = new EditorLaboratory(assembly, type))
                            verdict = Judge.Decide(Experiments.Record(laboratory));
                    },
                    failed => failure = failed);
                Assert.That(failure, Is.Null);
                return verdict;
            }
            finally
            {
                Directory.Delete(folder, true);
            }
        }
    }
}
