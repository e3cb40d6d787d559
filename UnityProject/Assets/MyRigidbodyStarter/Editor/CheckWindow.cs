using System;
using System.Collections.Generic;
using System.Linq;
using RigidBodyDynamics.Judging;
using UnityEditor;
using UnityEngine;

namespace RigidBodyDynamics.Starter
{
    /// <summary>Five lamps: which of the sheet's steps is off, and by how much; not how to mend it.</summary>
    public sealed class CheckWindow : EditorWindow
    {
        private static readonly Dictionary<Step, string> Names = new Dictionary<Step, string>
        {
            { Step.Velocity, "1 速度 velocity" },
            { Step.AngularVelocity, "2 角速度 angular velocity" },
            { Step.Position, "3 位置 position" },
            { Step.Orientation, "4 朝向 orientation" },
            { Step.Damping, "5 衰减 damping" },
            { Step.Given, "给定代码 the code that was given" },
        };

        private MonoScript _script;
        private Verdict _verdict;
        private string _message = string.Empty, _number = string.Empty, _name = string.Empty;
        private Vector2 _scrolled;

        /// <summary>The verdict that is shown; null if there is none.</summary>
        internal Verdict Verdict => _verdict;

        [MenuItem("MyRigidbody/检查五个步骤 Check my five steps")]
        public static void Open() => GetWindow<CheckWindow>("五个步骤");

        private void OnEnable() => _script = Handout.Script();

        /// <summary>Unity calls this to draw the window.</summary>
        public void OnGUI()
        {
            _script = (MonoScript)EditorGUILayout.ObjectField("脚本 script", _script, typeof(MonoScript), false);
            // after the event: what is drawn may not change within one
            if (GUILayout.Button("检查五个步骤 Check my five steps"))
                EditorApplication.delayCall += Check;

            _scrolled = GUILayout.BeginScrollView(_scrolled);
            if (_message.Length > 0)
                EditorGUILayout.HelpBox(_message, MessageType.Info);

            if (_verdict != null)
                Show(_verdict);

            GUILayout.EndScrollView();
            Export();
        }

        private void Check()
        {
            _verdict = null;
            if (_script == null)
            {
                _message = "请选择你的 MyRigidbody.cs。 Choose your MyRigidbody.cs.";
                return;
            }

            _message = "正在编译… compiling…";
            ScriptBuild.Begin(AssetDatabase.GetAssetPath(_script), Judge, Say);
        }

        private void Judge(System.Reflection.Assembly assembly, Type script)
        {
            // what the script prints a thousand times over helps nobody here
            bool logs = Debug.unityLogger.logEnabled;
            Debug.unityLogger.logEnabled = false;
            try
            {
                using (EditorLaboratory laboratory = new EditorLaboratory(assembly, script))
                    _verdict = Judging.Judge.Decide(Experiments.Record(laboratory));

                Say(string.Empty);
            }
            catch (Exception thrown)
            {
                Say("脚本出错 the script has thrown: " + thrown.Message);
            }
            finally
            {
                Debug.unityLogger.logEnabled = logs;
            }
        }

        private void Say(string message)
        {
            _message = message;
            Repaint();
        }

        private static void Show(Verdict verdict)
        {
            foreach (Step step in Verdict.FiveSteps)
            {
                Lamp(Names[step], verdict[step]);
                foreach (Finding finding in verdict.Findings.Where(found => found.Step == step))
                    Tell(finding);
            }

            foreach (Finding finding in verdict.Findings.Where(found => !Verdict.FiveSteps.Contains(found.Step)))
            {
                Lamp(Names.TryGetValue(finding.Step, out string name) ? name : finding.Step.ToString(), finding.IsDoubtful ? Mark.Doubtful : Mark.Wrong);
                Tell(finding);
            }
        }

        private static void Lamp(string name, Mark mark)
        {
            Color before = GUI.color;
            GUI.color = mark == Mark.Right ? new Color(0.45f, 0.9f, 0.5f) : mark == Mark.Wrong ? new Color(1, 0.55f, 0.5f) : new Color(1, 0.85f, 0.4f);
            GUILayout.Label("● " + name + " — " + Words(mark));
            GUI.color = before;
        }

        private static void Tell(Finding finding)
        {
            GUILayout.Label("    应为 expected: " + finding.Expected);
            GUILayout.Label("    实为 found: " + finding.Found);
        }

        private static string Words(Mark mark)
        {
            switch (mark)
            {
                case Mark.Right: return "正确 right";
                case Mark.Wrong: return "不对 off";
                case Mark.Missing: return "缺少 missing";
                case Mark.Doubtful: return "由教师判断 for the teacher to decide";
                default: return "看不出 not seen";
            }
        }

        private void Export()
        {
            _number = EditorGUILayout.TextField("学号 student number", _number);
            _name = EditorGUILayout.TextField("姓名 name", _name);
            string file = Handout.PackageName(_number, _name);
            if (GUILayout.Button(file == null ? "导出 学号_姓名.unitypackage Export" : "导出 " + file))
                EditorApplication.delayCall += () => Export(file);
        }

        private void Export(string file)
        {
            if (file == null || _script == null)
                Say("请填写学号和姓名。 Fill in your student number and your name.");
            else
                Handout.Export(_script, file);
        }
    }
}
