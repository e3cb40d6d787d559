using UnityEditor;

namespace RigidBodyDynamics.Scripts.Editing
{
    /// <summary>A paused editor does not say when a key goes up, so nothing is held after a pause that nobody holds.</summary>
    [InitializeOnLoad]
    internal static class PausedEditor
    {
        static PausedEditor() => EditorApplication.pauseStateChanged += state => LabInput.LetGo();
    }
}
