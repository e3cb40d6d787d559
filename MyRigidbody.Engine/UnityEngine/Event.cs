namespace UnityEngine
{
    /// <summary>An event of the immediate-mode GUI.</summary>
    public sealed class Event
    {
        public static Event current { get; set; }

        public EventType type { get; set; }

        public KeyCode keyCode { get; set; }

        public void Use() => type = EventType.Used;
    }

    /// <summary>The kind of an event, with Unity's numbers.</summary>
    public enum EventType
    {
        MouseDown = 0,
        MouseUp = 1,
        MouseMove = 2,
        MouseDrag = 3,
        KeyDown = 4,
        KeyUp = 5,
        ScrollWheel = 6,
        Repaint = 7,
        Layout = 8,
        Ignore = 11,
        Used = 12,
    }
}
