namespace UnityEngine
{
    /// <summary>An object that is on no game object.</summary>
    public class ScriptableObject : Object { }
}
