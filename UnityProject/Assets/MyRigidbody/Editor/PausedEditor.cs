using UnityEditor;

namespace RigidBodyDynamics.Scripts.Editing
{
    /// <summary>A paused editor does not report released keys, so all keys are released after a pause.</summary>
    [InitializeOnLoad]
    internal static class PausedEditor
    {
        static PausedEditor() => EditorApplication.pauseStateChanged += state => LabInput.LetGo();
    }
}
