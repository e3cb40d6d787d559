using System;
using System.Linq;
using RigidBodyDynamics.Engine;

namespace UnityEngine
{
    /// <summary>An object that Unity owns. A destroyed one equals null.</summary>
    public class Object
    {
        private string _name = string.Empty;

        public string name
        {
            get => NameOwner._name;
            set => NameOwner._name = value;
        }

        public HideFlags hideFlags { get; set; }

        /// <summary>A component has the name of its object.</summary>
        internal virtual Object NameOwner => this;

        internal bool IsDestroyed { get; set; }

        public static implicit operator bool(Object exists) => !IsNone(exists);

        public static bool operator ==(Object x, Object y) => IsNone(x) || IsNone(y) ? IsNone(x) == IsNone(y) : ReferenceEquals(x, y);

        public static bool operator !=(Object x, Object y) => !(x == y);

        /// <summary>Destroys at the end of the frame.</summary>
        public static void Destroy(Object obj) => World.DestroyLater(obj);

        public static void Destroy(Object obj, float t) => World.DestroyLater(obj);

        /// <summary>The first script or component of a type; null if there is none.</summary>
        public static T FindObjectOfType<T>() where T : Object => FindObjectsOfType<T>().FirstOrDefault();

        public static T[] FindObjectsOfType<T>() where T : Object =>
            World.Objects.Where(o => o.activeInHierarchy).SelectMany(o => o.Components).OfType<T>().ToArray();

#if UNITY_2022_2_OR_NEWER || EVERY_UNITY
        public static T FindFirstObjectByType<T>() where T : Object => FindObjectOfType<T>();

        public static T FindAnyObjectByType<T>() where T : Object => FindObjectOfType<T>();
#endif

        public static void DestroyImmediate(Object obj) => World.Destroy(obj);

        public static void DontDestroyOnLoad(Object target)
        {
            if (!Application.isPlaying)
                throw new InvalidOperationException("DontDestroyOnLoad can only be used in play mode");

            ((target as Component)?.gameObject ?? (GameObject)target).Survives = true;
        }

        public int GetInstanceID() => GetHashCode();

        public override bool Equals(object other) => other is Object that ? this == that : other == null && IsDestroyed;

        public override int GetHashCode() => System.Runtime.CompilerServices.RuntimeHelpers.GetHashCode(this);

        public override string ToString() => IsDestroyed ? "null" : name + " (" + GetType().FullName + ")";

        private static bool IsNone(Object x) => x is null || x.IsDestroyed;
    }

    /// <summary>How an object is displayed and saved.</summary>
    [Flags]
    public enum HideFlags
    {
        None = 0,
        HideInHierarchy = 1,
        HideInInspector = 2,
        DontSave = 52,
        HideAndDontSave = 61,
    }
}
