using System;
using System.Collections.Generic;
using System.Linq;

namespace RigidBodyDynamics.Judging
{
    /// <summary>The laboratory with a script and its variables. Static variables are reset at every beginning.</summary>
    internal sealed class Bench
    {
        private readonly ILaboratory _laboratory;
        private object _script;
        private Dictionary<string, double[]> _statics;

        public Bench(ILaboratory laboratory) => _laboratory = laboratory;

        public IReadOnlyList<Variable> Variables { get; private set; }

        public Pose Pose
        {
            get => _laboratory.Pose;
            set => _laboratory.Pose = value;
        }

        public Action<Keys> KeyAsked
        {
            set => _laboratory.KeyAsked = value;
        }

        public void Begin(Setting setting)
        {
            _script = _laboratory.Begin(setting);
            Variables = ScriptVariables.Of(_script);
            if (_statics == null)
                _statics = Variables.Where(v => v.IsStatic).ToDictionary(v => v.Name, v => v.Numbers);
            foreach (Variable v in Variables.Where(v => _statics.ContainsKey(v.Name)))
                v.Write(_statics[v.Name]);
        }

        /// <summary>Runs Start and reads the variables again, since Start may have created some.</summary>
        public void Start()
        {
            _laboratory.Start();
            Variables = ScriptVariables.Of(_script);
        }

        public void Frame(FrameInput input) => _laboratory.Frame(input);
    }
}
