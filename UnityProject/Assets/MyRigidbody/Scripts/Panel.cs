using System;
using System.Collections.Generic;
using System.Globalization;
using System.Linq;
using UnityEngine;

namespace RigidBodyDynamics.Scripts
{
    /// <summary>The panel over the scene: the states of the bodies, cost and error of their integrators, and the switches.</summary>
    [RequireComponent(typeof(Experiment))]
    [AddComponentMenu("MyRigidbody/Panel")]
    public sealed class Panel : MonoBehaviour
    {
        private const float Width = 250, NameWidth = 110, Margin = 8, DesignWidth = 1280, DesignHeight = 720, FoldedHeight = 40, SecondsPerTiming = 0.5f;
        private const float TagWidth = 110, TagHeight = 22, TagBelow = 70;
        private static readonly string[] KeyNames = { "←", "→", "↑", "↓", "R" };
        private readonly List<Yardstick> _yardsticks = new List<Yardstick>();
        private Experiment _experiment;
        private MyRigidbody _choosing;
        private Vector2 _scroll;
        private bool _isFolded;
        private float _nextTiming;

        private void Start()
        {
            _experiment = GetComponent<Experiment>();
        }

        private void Update()
        {
            // bodies are added and removed, and after scripts are reloaded all yardsticks are gone
            IReadOnlyList<MyRigidbody> mine = _experiment.Mine;
            _yardsticks.RemoveAll(yardstick => !mine.Contains(yardstick.Body));
            foreach (MyRigidbody body in mine.Where(body => !_yardsticks.Exists(yardstick => yardstick.Body == body)))
                _yardsticks.Add(new Yardstick(body));

            foreach (Yardstick yardstick in _yardsticks)
                yardstick.Follow();

            if (Time.unscaledTime < _nextTiming)
                return;

            _nextTiming = Time.unscaledTime + SecondsPerTiming;
            foreach (Yardstick yardstick in _yardsticks)
                yardstick.TakeTime();
        }

        private void OnGUI()
        {
            // the same share of every large screen, and never smaller than Unity's own text
            float scale = Mathf.Max(1, Mathf.Min(Screen.height / DesignHeight, Screen.width / DesignWidth));
            GUI.matrix = Matrix4x4.Scale(new Vector3(scale, scale, 1));
            Names(scale);
            GUILayout.BeginArea(new Rect(Margin, Margin, Width, _isFolded ? FoldedHeight : Screen.height / scale - 2 * Margin), GUI.skin.box);
            Head();
            if (!_isFolded)
                Content();

            GUILayout.EndArea();
        }

        // in a small Game view the panel would cover the bodies, so it is folded
        private void Head()
        {
            GUILayout.BeginHorizontal();
            if (GUILayout.Button(_isFolded ? Words.Say("show", "展开") : Words.Say("hide", "收起")))
                _isFolded = !_isFolded;
            if (GUILayout.Button(Words.Say("中文", "English")))
                Words.AreChinese = !Words.AreChinese;
            GUILayout.EndHorizontal();
        }

        private void Content()
        {
            _scroll = GUILayout.BeginScrollView(_scroll);
            Row(Words.Say("time", "时间"), Text(_experiment.Seconds, "0.00") + " s");
            Keys();
            Switches();
            foreach (Yardstick yardstick in _yardsticks)
            {
                if (yardstick.Body != null)
                    About(yardstick.Body, yardstick);
            }

            foreach (DefaultRigidbody body in _experiment.Theirs)
                About(body);

            foreach (StudentBody body in _experiment.Students)
                About(body);

            GUILayout.EndScrollView();
        }

        // the name of each body, below it
        private void Names(float scale)
        {
            Camera eye = Camera.main;
            if (eye == null)
                return;

            foreach (MyRigidbody body in _experiment.Mine)
                Name(eye, body, scale);

            foreach (DefaultRigidbody body in _experiment.Theirs)
                Name(eye, body, scale);

            foreach (StudentBody body in _experiment.Students)
            {
                if (body.IsThere)
                    Name(eye, body.Transform, scale);
            }
        }

        private static void Name(Camera eye, Component body, float scale)
        {
            // y is up on the screen and down in the GUI; a point behind the camera has no place on either
            Vector3 at = eye.WorldToScreenPoint(body.transform.position);
            if (at.z > 0)
                GUI.Label(new Rect(at.x / scale - 0.5f * TagWidth, (Screen.height - at.y) / scale + TagBelow, TagWidth, TagHeight), body.name);
        }

        private void Keys()
        {
            GUILayout.BeginHorizontal();
            for (LabKey key = LabKey.LeftArrow; key <= LabKey.R; key++)
            {
                GUI.color = LabInput.IsHeld(key) ? Color.yellow : Color.white;
                bool isHeld = GUILayout.RepeatButton(KeyNames[(int)key]);
                // a repeat button says whether it is held only while it is painted
                if (Event.current.type == EventType.Repaint)
                    LabInput.HoldOnScreen(key, isHeld);
            }

            GUI.color = Color.white;
            GUILayout.EndHorizontal();
        }

        private void Switches()
        {
            GUILayout.BeginHorizontal();
            if (GUILayout.Button(_experiment.IsPaused ? Words.Say("run", "运行") : Words.Say("pause", "暂停")))
                _experiment.IsPaused = !_experiment.IsPaused;
            if (GUILayout.Button(Words.Say("one step", "单步")))
                _experiment.StepOnce();
            if (GUILayout.Button(Words.Say("reset", "重置")))
                _experiment.StartAgain();
            GUILayout.EndHorizontal();
            GUILayout.BeginHorizontal();
            _experiment.IsSlow = GUILayout.Toggle(_experiment.IsSlow, Words.Say("slow", "慢动作"));
            if (_experiment.Theirs.Count + _experiment.Students.Count > 0 && GUILayout.Button(_experiment.IsRecording ? Words.Say("stop", "停止录制") : Words.Say("record", "录制")))
                Record();
            GUILayout.EndHorizontal();
            if (!string.IsNullOrEmpty(_experiment.LastRecording))
                GUILayout.Label(_experiment.LastRecording);
        }

        private void Record()
        {
            if (_experiment.IsRecording)
                _experiment.EndRecording();
            else
                _experiment.Record();
        }

        private void About(MyRigidbody body, Yardstick yardstick)
        {
            Title(body.name);
            if (!body.IsReady)
            {
                GUILayout.Label(Words.Say("see the console", "请看控制台"));
                return;
            }

            if (GUILayout.Button(body.integrator + (_choosing == body ? "  ▲" : "  ▼")))
                _choosing = _choosing == body ? null : body;

            if (_choosing == body)
                Choose(body);

            Motion(body.State, body.Body.Mass);
            if (body.comparedWith != null)
                Row(Words.Say("to default", "与 Unity 相差"), Angle(Conserved.AngleBetween(body.State.Orientation, body.comparedWith.State.Orientation)));

            Row(Words.Say("error", "误差"), Angle(yardstick.AngleError) + ", " + Text(yardstick.DistanceError, "0.000") + " m");
            Row(Words.Say("one step", "每步耗时"), Text(yardstick.NanosecondsPerStep, "0") + " ns");
        }

        private void Choose(MyRigidbody body)
        {
            foreach (Rule rule in Rules.All)
            {
                if (!GUILayout.Button(new GUIContent(rule.Name, rule.About)))
                    continue;

                body.integrator = rule.Name;
                _choosing = null;
                _experiment.StartAgain();
            }
        }

        private void About(DefaultRigidbody body)
        {
            Title(body.name);
            Motion(body.State, body.Mass);
            bool isChanged = Switch(ref body.hasLabInertia, Words.Say("the lab's inertia, × 3", "实验的转动惯量，三倍"))
                | Damping(body)
                | Switch(ref body.limitsSpin, Words.Say("at most 7 rad/s", "角速度不超过 7 rad/s"))
                | Switch(ref body.pushesInUpdate, Words.Say("pushed in Update", "在 Update 中施力"));
            if (isChanged)
                _experiment.StartAgain();
        }

        private void About(StudentBody body)
        {
            if (!body.IsThere)
                return;

            Title(body.Name);
            GUILayout.Label(Words.Say("your script, by differences of the pose", "你的脚本，由位姿之差求得"));
            Speeds(body.State);
            if (_experiment.Steps > 0)
                Row(Words.Say("frames a step", "每步帧数"), Text((double)body.Frames / _experiment.Steps, "0.00"));

            if (body.Mine != null && body.Mine.IsReady)
                Apart(body, body.Mine.name, body.Mine.StartState(), body.Mine.State);

            if (body.Theirs != null)
                Apart(body, body.Theirs.name, body.Theirs.StartState(), body.Theirs.State);
        }

        private static void Apart(StudentBody body, string other, BodyState start, BodyState now) =>
            Row(Words.Say("to " + other, "与 " + other + " 相差"), Text(body.DistanceTo(start, now), "0.000") + " m, " + Angle(body.AngleTo(start, now)));

        private static bool Damping(DefaultRigidbody body)
        {
            bool isLabs = body.drag == 1;
            if (!Switch(ref isLabs, Words.Say("drag 1, as 0.98 a step", "阻尼 1，即每步 0.98")))
                return false;

            body.drag = isLabs ? 1 : 0;
            body.angularDrag = isLabs ? 1 : 0.05f;
            return true;
        }

        private static bool Switch(ref bool setting, string label)
        {
            bool before = setting;
            setting = GUILayout.Toggle(setting, label);
            return setting != before;
        }

        private static void Motion(BodyState state, MassProperties mass)
        {
            Speeds(state);
            Row(Words.Say("energy", "动能"), Text(Conserved.KineticEnergy(state, mass), "0.000") + " J");
            Vector3d momentum = Conserved.AngularMomentum(state, mass);
            Row(Words.Say("abs(L)", "角动量大小"), Text(momentum.Length, "0.0000") + " kg m²/s");
            Row("L", Text(momentum.X, "0.000") + "  " + Text(momentum.Y, "0.000") + "  " + Text(momentum.Z, "0.000"));
        }

        private static void Speeds(BodyState state)
        {
            Row(Words.Say("speed", "速度"), Text(state.Velocity.Length, "0.00") + " m/s");
            Row(Words.Say("spin", "角速度"), Text(state.AngularVelocity.Length, "0.00") + " rad/s");
        }

        private static void Title(string name)
        {
            GUILayout.Space(Margin);
            GUILayout.Label("— " + name + " —");
        }

        private static void Row(string what, string value)
        {
            GUILayout.BeginHorizontal();
            GUILayout.Label(what, GUILayout.Width(NameWidth));
            GUILayout.Label(value);
            GUILayout.EndHorizontal();
        }

        private static string Angle(double radians) => Text(radians * 180 / Math.PI, radians < 0.01 ? "0.0e+0" : "0.00") + "°";

        private static string Text(double number, string format) => number.ToString(format, CultureInfo.InvariantCulture);
    }
}
