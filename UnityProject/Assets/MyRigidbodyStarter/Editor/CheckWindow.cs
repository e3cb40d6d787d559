using System;
using System.Linq;
using RigidBodyDynamics.Judging;
using UnityEditor;
using UnityEngine;

namespace RigidBodyDynamics.Starter
{
    /// <summary>Five lamps: which of the sheet's steps is wrong, and by how much; not how to correct it.</summary>
    public sealed class CheckWindow : EditorWindow
    {
        private MonoScript _script;
        private Verdict _verdict;
        private string _message = string.Empty, _number = string.Empty, _name = string.Empty;
        private Vector2 _scrolled;

        /// <summary>The displayed verdict; null if there is none.</summary>
        internal Verdict Verdict => _verdict;

        [MenuItem("MyRigidbody/检查五个步骤 Check my five steps")]
        public static void Open() => GetWindow<CheckWindow>("五个步骤");

        private void OnEnable() => _script = Handout.Script();

        /// <summary>Unity calls this to draw the window.</summary>
        public void OnGUI()
        {
            _script = (MonoScript)EditorGUILayout.ObjectField("脚本 script", _script, typeof(MonoScript), false);
            // after the event: the layout may not change within one
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
            // the script's own output is not shown here
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
                Lamp(step, verdict[step]);
                foreach (Finding finding in verdict.Findings.Where(found => found.Step == step))
                    Tell(finding);
            }

            foreach (Finding finding in verdict.Findings.Where(found => !Verdict.FiveSteps.Contains(found.Step)))
            {
                Lamp(finding.Step, finding.IsDoubtful ? Mark.Doubtful : Mark.Wrong);
                Tell(finding);
            }
        }

        private static void Lamp(Step step, Mark mark)
        {
            Color before = GUI.color;
            GUI.color = mark == Mark.Right ? new Color(0.45f, 0.9f, 0.5f) : mark == Mark.Wrong ? new Color(1, 0.55f, 0.5f) : new Color(1, 0.85f, 0.4f);
            string number = Verdict.FiveSteps.Contains(step) ? (int)step + " " : string.Empty;
            GUILayout.Label("● " + number + Both(Terminology.Of(step)) + " — " + Both(Terminology.Of(mark)));
            GUI.color = before;
        }

        private static void Tell(Finding finding)
        {
            GUILayout.Label("    应为 expected: " + finding.Expected);
            GUILayout.Label("    实为 found: " + finding.Found);
            if (finding.IsDoubtful)
                GUILayout.Label("    由教师决定 an instructor decides");
        }

        private static string Both(Term term) => term.Chinese + " " + term.English;

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
