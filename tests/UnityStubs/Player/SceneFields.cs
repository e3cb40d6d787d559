using System;
using System.Collections.Generic;
using System.Linq;
using System.Reflection;
using RigidBodyDynamics.UnityFiles;
using UnityEngine;
using YamlDotNet.RepresentationModel;

namespace RigidBodyDynamics.Engine
{
    /// <summary>Fills a part of an object with what the scene file says of it.</summary>
    internal sealed class SceneFields
    {
        // Unity's number of its own cube
        private const long CubeMesh = 10202;

        private readonly UnityObject _written;
        private readonly IReadOnlyDictionary<long, Component> _components;

        public SceneFields(UnityObject written, IReadOnlyDictionary<long, Component> components)
        {
            _written = written;
            _components = components;
        }

        public void Fill(Component part)
        {
            if (part is Behaviour behaviour)
                behaviour.IsSwitchedOn = Yaml.Number(_written["m_Enabled"]) != 0;

            switch (part)
            {
                case Transform transform:
                    transform.localPosition = Yaml.Vector(_written["m_LocalPosition"]);
                    transform.localRotation = Yaml.Turn(_written["m_LocalRotation"]);
                    transform.localScale = Yaml.Vector(_written["m_LocalScale"]);
                    break;
                case MeshFilter filter:
                    filter.sharedMesh = Yaml.Reference(_written["m_Mesh"]) == CubeMesh ? Mesh.Cube() : new Mesh();
                    break;
                case BoxCollider box:
                    box.size = Yaml.Vector(_written["m_Size"]);
                    box.center = Yaml.Vector(_written["m_Center"]);
                    break;
                case Rigidbody body:
                    Fill(body);
                    break;
                case MonoBehaviour script:
                    Fill(script);
                    break;
            }
        }

        private void Fill(Rigidbody body)
        {
            if (Yaml.Number(_written["m_IsKinematic"]) != 0 || Yaml.Number(_written["m_Constraints"]) != 0)
                throw new NotSupportedException("a Rigidbody that is kinematic or constrained");

            body.mass = Yaml.Single(_written["m_Mass"]);
            body.useGravity = Yaml.Number(_written["m_UseGravity"]) != 0;
            float drag = Yaml.Single(_written["m_Drag"]), angularDrag = Yaml.Single(_written["m_AngularDrag"]);
#if UNITY_6000_0_OR_NEWER
            body.linearDamping = drag;
            body.angularDamping = angularDrag;
#else
            body.drag = drag;
            body.angularDrag = angularDrag;
#endif
        }

        // what follows m_EditorClassIdentifier are the script's own fields
        private void Fill(MonoBehaviour script)
        {
            List<FieldInfo> fields = SavedFields.Of(script.GetType());
            foreach (KeyValuePair<YamlNode, YamlNode> entry in _written.Fields.Children.SkipWhile(pair => Yaml.Text(pair.Key) != "m_EditorClassIdentifier").Skip(1))
            {
                FieldInfo field = fields.Find(known => known.Name == Yaml.Text(entry.Key));
                if (field == null)
                    Debug.LogError(_written.TypeName + " &" + _written.FileId + ": " + script.GetType().Name + " has no field " + entry.Key);
                else
                    field.SetValue(script, Value(entry.Value, field.FieldType));
            }
        }

        private object Value(YamlNode written, Type type)
        {
            if (type == typeof(string))
                return Yaml.Text(written);
            if (type == typeof(Vector3))
                return Yaml.Vector(written);
            if (type == typeof(bool))
                return Yaml.Number(written) != 0;
            if (type.IsEnum)
                return Enum.ToObject(type, (int)Yaml.Number(written));
            if (typeof(UnityEngine.Object).IsAssignableFrom(type))
                return Yaml.Reference(written) == 0 ? null : _components[Yaml.Reference(written)];

            return Convert.ChangeType(type == typeof(float) ? Yaml.Single(written) : Yaml.Number(written), type);
        }
    }
}
