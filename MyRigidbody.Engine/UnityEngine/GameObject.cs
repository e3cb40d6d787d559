using System;
using System.Collections.Generic;
using System.Linq;
using RigidBodyDynamics.Engine;
using UnityEngine.SceneManagement;

namespace UnityEngine
{
    /// <summary>An object of the scene: a transform and other components.</summary>
    public sealed class GameObject : Object
    {
        private readonly List<Component> _components = new List<Component>();

        public GameObject(string name) : this(name, isActive: true) { }

        public GameObject() : this("New Game Object") { }

        public GameObject(string name, params Type[] components) : this(name)
        {
            foreach (Type type in components)
                AddComponent(type);
        }

        internal GameObject(string name, bool isActive)
        {
            this.name = name;
            activeSelf = isActive;
            World.Add(this);
            transform = (Transform)Attach(typeof(Transform));
        }

        public Transform transform { get; }

        public bool activeSelf { get; private set; }

        public string tag { get; set; } = "Untagged";

        public bool activeInHierarchy => !IsDestroyed && activeSelf && (transform.parent == null || transform.parent.gameObject.activeInHierarchy);

        public Scene scene => Survives ? new Scene("DontDestroyOnLoad") : SceneManager.GetActiveScene();

        /// <summary>The components in order; null stands for a script that cannot be found.</summary>
        internal IReadOnlyList<Component> Components => _components;

        /// <summary>True if loading another scene does not destroy it.</summary>
        internal bool Survives { get; set; }

        public int layer { get; set; }

        public bool isStatic { get; set; }

        /// <summary>The first active object of that name; null if there is none.</summary>
        public static GameObject Find(string name) => World.Objects.Find(o => o.activeInHierarchy && o.name == name);

        public static GameObject FindWithTag(string tag) => World.Objects.Find(o => o.activeInHierarchy && o.tag == tag);

        public static GameObject FindGameObjectWithTag(string tag) => FindWithTag(tag);

        /// <summary>An object with a mesh and a collider, as Unity creates it.</summary>
        public static GameObject CreatePrimitive(PrimitiveType type)
        {
            if (type != PrimitiveType.Cube)
                throw new NotSupportedException("only cubes");

            GameObject cube = new GameObject("Cube");
            cube.AddComponent<MeshFilter>().sharedMesh = Mesh.Cube();
            cube.AddComponent<BoxCollider>();
            cube.AddComponent<MeshRenderer>();
            return cube;
        }

        public T AddComponent<T>() where T : Component => (T)AddComponent(typeof(T));

        public Component AddComponent(Type componentType)
        {
            if (IsOnlyOnce(componentType) && GetComponent(componentType) != null)
            {
                Debug.LogWarning("The component '" + componentType.Name + "' can't be added because '" + name + "' already contains the same component.");
                return null;
            }

            foreach (RequireComponent required in componentType.GetCustomAttributes(typeof(RequireComponent), true))
            {
                if (GetComponent(required.m_Type0) == null)
                    AddComponent(required.m_Type0);
            }

            Component added = Attach(componentType);
            if (!World.IsPlaying)
                Messages.Validate(added);

            (added as MonoBehaviour)?.Settle();
            return added;
        }

        public T GetComponent<T>() => _components.OfType<T>().FirstOrDefault();

        public Component GetComponent(Type type) => _components.FirstOrDefault(component => type.IsInstanceOfType(component));

        public T GetComponentInParent<T>()
        {
            for (Transform at = transform; at != null; at = at.parent)
            {
                T found = at.gameObject.GetComponent<T>();
                if (found != null)
                    return found;
            }

            return default(T);
        }

        public bool TryGetComponent<T>(out T component)
        {
            component = GetComponent<T>();
            return component != null;
        }

        public bool CompareTag(string tag) => this.tag == tag;

        public T[] GetComponents<T>() => typeof(T) == typeof(Component) ? _components.Cast<T>().ToArray() : _components.OfType<T>().ToArray();

        public T GetComponentInChildren<T>() => GetComponentsInChildren<T>().FirstOrDefault();

        public T[] GetComponentsInChildren<T>() => GetComponentsInChildren<T>(false);

        public T[] GetComponentsInChildren<T>(bool includeInactive)
        {
            List<T> found = new List<T>();
            if (includeInactive || activeInHierarchy)
                found.AddRange(GetComponents<T>());

            for (int i = 0; i < transform.childCount; i++)
                found.AddRange(transform.GetChild(i).gameObject.GetComponentsInChildren<T>(includeInactive));

            return found.ToArray();
        }

        public void SetActive(bool value)
        {
            activeSelf = value;
            foreach (MonoBehaviour script in GetComponentsInChildren<MonoBehaviour>(true))
                script.Settle();
        }

        /// <summary>Calls a method of every script on the object, including private ones.</summary>
        public void SendMessage(string methodName)
        {
            MonoBehaviour[] receivers = Array.FindAll(GetComponents<MonoBehaviour>(), script => Messages.Has(script, methodName));
            if (receivers.Length == 0)
                Debug.LogError("SendMessage " + methodName + " has no receiver!", this);

            foreach (MonoBehaviour receiver in receivers)
                Messages.Send(receiver, methodName);
        }

        /// <summary>Adds a component to the object, without a message.</summary>
        internal Component Attach(Type type)
        {
            Component added = (Component)Activator.CreateInstance(type, nonPublic: true);
            added.gameObject = this;
            _components.Add(added);
            World.Add(added);
            return added;
        }

        internal void AttachMissingScript() => _components.Add(null);

        internal void Detach(Component component) => _components.Remove(component);

        private static bool IsOnlyOnce(Type type) =>
            type == typeof(Rigidbody) || type.IsDefined(typeof(DisallowMultipleComponent), inherit: true);
    }

    /// <summary>The shapes of <see cref="GameObject.CreatePrimitive"/>.</summary>
    public enum PrimitiveType
    {
        Sphere,
        Capsule,
        Cylinder,
        Cube,
        Plane,
        Quad,
    }
}
