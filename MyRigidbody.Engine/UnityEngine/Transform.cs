using System;
using System.Collections;
using System.Collections.Generic;

namespace UnityEngine
{
    /// <summary>The pose and scale of an object, relative to its parent. Its rotation always has length one, and it refuses NaN.</summary>
    public partial class Transform : Component, IEnumerable
    {
        private readonly List<Transform> _children = new List<Transform>();
        private Transform _parent;
        private Vector3 _localPosition = Vector3.zero;
        private Quaternion _localRotation = Quaternion.identity;

        protected Transform() { }

        public Vector3 localPosition
        {
            get => _localPosition;
            set
            {
                if (IsValid("localPosition", value.x + value.y + value.z, "position", value))
                    _localPosition = value;
            }
        }

        public Quaternion localRotation
        {
            get => _localRotation;
            set
            {
                if (IsValid("localRotation", value.x + value.y + value.z + value.w, "rotation", value))
                    _localRotation = Unit(value);
            }
        }

        public Vector3 localScale { get; set; } = Vector3.one;

        public bool hasChanged { get; set; }

        public Transform parent
        {
            get => _parent;
            set => SetParent(value);
        }

        public Transform root => _parent == null ? this : _parent.root;

        public int childCount => _children.Count;

        public Vector3 position
        {
            get => _parent == null ? _localPosition : _parent.position + _parent.rotation * Vector3.Scale(_parent.lossyScale, _localPosition);
            set
            {
                if (IsValid("position", value.x + value.y + value.z, "position", value))
                    _localPosition = _parent == null ? value : Inside(Quaternion.Inverse(_parent.rotation) * (value - _parent.position));
            }
        }

        public Quaternion rotation
        {
            get => _parent == null ? _localRotation : _parent.rotation * _localRotation;
            set
            {
                if (IsValid("rotation", value.x + value.y + value.z + value.w, "rotation", value))
                    _localRotation = Unit(_parent == null ? value : Quaternion.Inverse(_parent.rotation) * value);
            }
        }

        /// <summary>The scale in the world; where parents shear it, Unity's approximation.</summary>
        public Vector3 lossyScale => _parent == null ? localScale : Vector3.Scale(_parent.lossyScale, localScale);

        public void SetPositionAndRotation(Vector3 position, Quaternion rotation)
        {
            this.position = position;
            this.rotation = rotation;
        }

        public Transform GetChild(int index) => _children[index];

        public void SetParent(Transform p) => SetParent(p, true);

        public void SetParent(Transform parent, bool worldPositionStays)
        {
            Vector3 here = position;
            Quaternion turned = rotation;
            _parent?._children.Remove(this);
            _parent = parent;
            _parent?._children.Add(this);
            if (worldPositionStays)
                SetPositionAndRotation(here, turned);
        }

        public IEnumerator GetEnumerator() => _children.GetEnumerator();

        /// <summary>The pose from physics, to the bit.</summary>
        internal void Place(Vector3 position, Quaternion rotation)
        {
            if (_parent != null)
            {
                SetPositionAndRotation(position, rotation);
                return;
            }

            _localPosition = position;
            _localRotation = rotation;
        }

        private static Quaternion Unit(Quaternion turn)
        {
            // a rotation of length one except for rounding is not changed, so that reading returns what was set
            double square = (double)turn.x * turn.x + (double)turn.y * turn.y + (double)turn.z * turn.z + (double)turn.w * turn.w;
            return Math.Abs(square - 1) < 2e-7 ? turn : square < 1e-10 ? Quaternion.identity : turn.normalized;
        }

        // generic, because boxing in every step would cost more than the rest
        private bool IsValid<T>(string member, float sum, string what, T value) where T : struct
        {
            if (!float.IsNaN(sum) && !float.IsInfinity(sum))
                return true;

            Debug.LogError("transform." + member + " assign attempt for '" + name + "' is not valid. Input " + what + " is " + value + ".");
            return false;
        }

        private Vector3 Inside(Vector3 offset)
        {
            Vector3 scale = _parent.lossyScale;
            return new Vector3(offset.x / scale.x, offset.y / scale.y, offset.z / scale.z);
        }
    }
}
