using System;
using System.Reflection;

namespace RigidBodyDynamics.Judging
{
    /// <summary>The place of a value of the script: a field of the script, or of an object that it holds.</summary>
    internal abstract class Place
    {
        public abstract object Value { get; set; }

        public static Place Of(object root) => new Root(root);

        public Place Field(FieldInfo field) => new Member(this, field);

        private sealed class Root : Place
        {
            public Root(object value) => Value = value;

            public override object Value { get; set; }
        }

        private sealed class Member : Place
        {
            private readonly Place _owner;
            private readonly FieldInfo _field;

            public Member(Place owner, FieldInfo field)
            {
                _owner = owner;
                _field = field;
            }

            public override object Value
            {
                get => _field.IsLiteral ? _field.GetRawConstantValue() : _field.GetValue(_field.IsStatic ? null : _owner.Value);
                set
                {
                    object owner = _field.IsStatic ? null : _owner.Value;
                    _field.SetValue(owner, value);
                    // a struct was read as a copy: write the copy back
                    if (owner is ValueType)
                        _owner.Value = owner;
                }
            }
        }
    }
}
