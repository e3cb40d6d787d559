using System.Collections;
using System.Collections.Generic;

namespace UnityEngine
{
    /// <summary>Where an object is, seen from its parent.</summary>
    public class Transform : Component, IEnumerable
    {
        private readonly List<Transform> _children = new List<Transform>();
        private Transform _parent;

        protected Transform() { }

        public Vector3 localPosition { get; set; } = Vector3.zero;

        public Quaternion localRotation { get; set; } = Quaternion.identity;

        public Vector3 localScale { get; set; } = Vector3.one;

        public Transform parent
        {
            get => _parent;
            set => SetParent(value);
        }

        public int childCount => _children.Count;

        public Vector3 position
        {
            get => _parent == null ? localPosition : _parent.position + _parent.rotation * Vector3.Scale(_parent.lossyScale, localPosition);
            set => localPosition = _parent == null ? value : Inside(Quaternion.Inverse(_parent.rotation) * (value - _parent.position));
        }

        public Quaternion rotation
        {
            get => _parent == null ? localRotation : _parent.rotation * localRotation;
            set => localRotation = _parent == null ? value : Quaternion.Inverse(_parent.rotation) * value;
        }

        /// <summary>The scale in the world; where parents shear it, as near as Unity comes.</summary>
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

        private Vector3 Inside(Vector3 offset)
        {
            Vector3 scale = _parent.lossyScale;
            return new Vector3(offset.x / scale.x, offset.y / scale.y, offset.z / scale.z);
        }
    }
}
