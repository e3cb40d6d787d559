using System;
using System.Collections;
using System.Collections.Generic;
using RigidBodyDynamics.Engine;

namespace UnityEngine
{
    /// <summary>A component of an object.</summary>
    public class Component : Object
    {
        public GameObject gameObject { get; internal set; }

        public Transform transform => gameObject.transform;

        public string tag { get => gameObject.tag; set => gameObject.tag = value; }

        internal override Object NameOwner => gameObject ?? (Object)this;

        public T GetComponent<T>() => gameObject.GetComponent<T>();

        public Component GetComponent(Type type) => gameObject.GetComponent(type);

        public T GetComponentInParent<T>() => gameObject.GetComponentInParent<T>();

        public bool TryGetComponent<T>(out T component) => gameObject.TryGetComponent(out component);

        public bool CompareTag(string tag) => gameObject.CompareTag(tag);

        public T[] GetComponents<T>() => gameObject.GetComponents<T>();

        public T GetComponentInChildren<T>() => gameObject.GetComponentInChildren<T>();

        public T[] GetComponentsInChildren<T>() => gameObject.GetComponentsInChildren<T>();

        public T[] GetComponentsInChildren<T>(bool includeInactive) => gameObject.GetComponentsInChildren<T>(includeInactive);

        /// <summary>Calls a method of every script on the object, including private ones.</summary>
        public void SendMessage(string methodName) => gameObject.SendMessage(methodName);
    }

    /// <summary>A component that can be disabled.</summary>
    public class Behaviour : Component
    {
        private bool _enabled = true;

        public bool enabled
        {
            get => _enabled;
            set
            {
                _enabled = value;
                (this as MonoBehaviour)?.Settle();
            }
        }

        /// <summary>Sets whether it is enabled, without a message, as when a scene is loaded.</summary>
        internal bool IsSwitchedOn { set => _enabled = value; }

        public bool isActiveAndEnabled => !IsDestroyed && _enabled && gameObject.activeInHierarchy;
    }

    /// <summary>A script. Unity finds its messages by name.</summary>
    public class MonoBehaviour : Behaviour
    {
        private bool _isAwake, _isSwitchingOn, _isOn, _isStarted;

        /// <summary>The methods of messages that have been sent.</summary>
        internal Dictionary<string, Action> Calls { get; } = new Dictionary<string, Action>();

        public bool useGUILayout { get; set; } = true;

        /// <summary>Writes to the console.</summary>
        public static void print(object message) => Debug.Log(message);

        /// <summary>Runs to the first yield, and continues after each fixed step: it can wait for nothing else here.</summary>
        public Coroutine StartCoroutine(IEnumerator routine) => Coroutines.Start(this, routine);

        public Coroutine StartCoroutine(string methodName) => throw NotHere(nameof(StartCoroutine));

        public Coroutine StartCoroutine(string methodName, object value) => throw NotHere(nameof(StartCoroutine));

        public void StopCoroutine(IEnumerator routine) => Coroutines.Stop(this, routine);

        public void StopCoroutine(Coroutine routine) => Coroutines.Stop(routine);

        public void StopCoroutine(string methodName) { }

        public void StopAllCoroutines() => Coroutines.StopAll(this);

        public void Invoke(string methodName, float time) => throw NotHere(nameof(Invoke));

        public void InvokeRepeating(string methodName, float time, float repeatRate) => throw NotHere(nameof(InvokeRepeating));

        public void CancelInvoke() { }

        public void CancelInvoke(string methodName) { }

        public bool IsInvoking() => false;

        public bool IsInvoking(string methodName) => false;

        /// <summary>Sends Awake, and OnEnable or OnDisable, if due.</summary>
        internal void Settle()
        {
            if (!World.IsPlaying || IsDestroyed || _isSwitchingOn)
                return;

            if (!_isAwake && gameObject.activeInHierarchy)
            {
                // a script may disable itself in Awake, and is then not enabled
                _isAwake = _isSwitchingOn = true;
                Messages.Send(this, "Awake");
                _isSwitchingOn = false;
            }

            bool isDue = _isAwake && isActiveAndEnabled;
            if (isDue == _isOn)
                return;

            _isOn = isDue;
            Messages.Send(this, isDue ? "OnEnable" : "OnDisable");
        }

        /// <summary>Sends Start, once, before the first frame in which it is enabled.</summary>
        internal void StartIfDue()
        {
            if (_isStarted || !_isOn)
                return;

            _isStarted = true;
            Messages.Send(this, "Start");
        }

        /// <summary>Sends the last messages.</summary>
        internal void End()
        {
            if (_isOn)
                Messages.Send(this, "OnDisable");

            _isOn = false;
            if (_isAwake)
                Messages.Send(this, "OnDestroy");
        }

        internal static NotSupportedException NotHere(string member) =>
            new NotSupportedException(member + ": the stand-in for the engine steps in Update and FixedUpdate alone");
    }
}
