using System;
using System.Collections.Generic;
using UnityEngine;

namespace RigidBodyDynamics.Engine
{
    /// <summary>
    /// What GUILayout stores of a Layout event for the event after it: groups and the number of controls in each. A control that was
    /// not laid out is an error there as in Unity; after a control has used the event, nothing is tested.
    /// </summary>
    internal sealed class Layout
    {
        private readonly Stack<Group> _open = new Stack<Group>();
        private Group _root = new Group("root");

        /// <summary>Begins an event.</summary>
        public void Begin()
        {
            if (Event.current.type == EventType.Layout)
                _root = new Group("root");

            _root.GoBack();
            _open.Clear();
            _open.Push(_root);
        }

        /// <summary>Ends it; a group that is still open is an error.</summary>
        public void End()
        {
            if (_open.Count > 1)
                Debug.LogError("GUI Error: " + _open.Peek().Kind + " was begun and not ended");
        }

        public void Control() => Next(() => null);

        public void Open(string kind)
        {
            Group group = Next(() => new Group(kind)) ?? new Group(kind);
            if (group.Kind != kind)
                throw new ArgumentException("GUILayout: Mismatched LayoutGroup." + Event.current.type);

            _open.Push(group);
        }

        public void Close(string kind)
        {
            Group group = _open.Pop();
            if (group.Kind != kind)
                throw new ArgumentException("GUILayout: " + kind + " is ended, but " + group.Kind + " is open");
        }

        private Group Next(Func<Group> make)
        {
            Group group = _open.Peek();
            switch (Event.current.type)
            {
                case EventType.Layout: return group.Add(make());
                case EventType.Used: return null;
                default: return group.Next();
            }
        }

        /// <summary>A row, a column, a view; a null in it is a single control.</summary>
        private sealed class Group
        {
            private readonly List<Group> _entries = new List<Group>();
            private int _next;

            public Group(string kind) => Kind = kind;

            public string Kind { get; }

            public Group Add(Group entry)
            {
                _entries.Add(entry);
                return entry;
            }

            public Group Next() => _next < _entries.Count
                ? _entries[_next++]
                : throw new ArgumentException("Getting control " + _next + "'s position in a group with only " + _entries.Count
                    + " controls when doing " + Event.current.type + "\nAborting");

            public void GoBack()
            {
                _next = 0;
                foreach (Group entry in _entries)
                    entry?.GoBack();
            }
        }
    }
}
