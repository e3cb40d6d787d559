using System;
using System.Collections.Generic;
using System.Linq;
using System.Reflection;
using RigidBodyDynamics.Engine;
using UnityEngine;

namespace UnityEditor
{
    /// <summary>What is saved of an object: its public fields and those marked as saved.</summary>
    public class SerializedObject : IDisposable
    {
        private readonly UnityEngine.Object _target;
        private readonly Dictionary<string, object> _values = new Dictionary<string, object>();
        private readonly HashSet<string> _modified = new HashSet<string>();

        public SerializedObject(UnityEngine.Object obj)
        {
            _target = obj;
            Update();
        }

        internal List<FieldInfo> Fields => SavedFields.Of(_target.GetType());

        public void Update()
        {
            _modified.Clear();
            foreach (FieldInfo field in Fields)
                _values[field.Name] = field.GetValue(_target);
        }

        /// <summary>Before its first property: the script, then the fields.</summary>
        public SerializedProperty GetIterator() => new SerializedProperty(this, -2);

        /// <summary>Null if there is no such field.</summary>
        public SerializedProperty FindProperty(string propertyPath)
        {
            int index = Fields.FindIndex(field => field.Name == propertyPath);
            return index < 0 ? null : new SerializedProperty(this, index);
        }

        public bool ApplyModifiedProperties()
        {
            foreach (FieldInfo field in Fields.Where(field => _modified.Contains(field.Name)))
                field.SetValue(_target, _values[field.Name]);

            bool isModified = _modified.Count > 0;
            _modified.Clear();
            if (isModified)
                Messages.Validate((Component)_target);

            return isModified;
        }

        public void Dispose() { }

        internal object Get(string field) => _values[field];

        internal void Set(string field, object value)
        {
            if (Equals(_values[field], value))
                return;

            _values[field] = value;
            _modified.Add(field);
        }
    }

    /// <summary>One field of it.</summary>
    public class SerializedProperty
    {
        private const int Script = -1;
        private readonly SerializedObject _owner;
        private int _index;

        internal SerializedProperty(SerializedObject owner, int index)
        {
            _owner = owner;
            _index = index;
        }

        public string name => _index == Script ? "m_Script" : Field.Name;

        /// <summary>As the inspector writes it: startVelocity is Start Velocity.</summary>
        public string displayName => _index == Script ? "Script" : char.ToUpperInvariant(name[0])
            + string.Concat(name.Skip(1).Select(c => char.IsUpper(c) ? " " + c : c.ToString()));

        public string tooltip => Field.GetCustomAttribute<TooltipAttribute>()?.tooltip ?? string.Empty;

        public string stringValue { get => (string)Value; set => Value = value; }

        public double doubleValue { get => (double)Value; set => Value = value; }

        public float floatValue { get => (float)Value; set => Value = value; }

        public bool boolValue { get => (bool)Value; set => Value = value; }

        public Vector3 vector3Value { get => (Vector3)Value; set => Value = value; }

        public int enumValueIndex { get => (int)Value; set => Value = Enum.ToObject(Field.FieldType, value); }

        private FieldInfo Field => _owner.Fields[_index];

        private object Value
        {
            get => _owner.Get(name);
            set => _owner.Set(name, value);
        }

        public bool NextVisible(bool enterChildren)
        {
            if (!enterChildren && _index < Script)
                return false;

            _index++;
            return _index < _owner.Fields.Count;
        }
    }
}
