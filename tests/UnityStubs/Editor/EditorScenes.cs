using System.IO;
using System.Linq;
using RigidBodyDynamics.Engine;
using UnityEngine;
using UnityEngine.SceneManagement;

namespace UnityEditor
{
    /// <summary>What the editor can do with objects.</summary>
    public sealed class GameObjectUtility
    {
        public static int GetMonoBehavioursWithMissingScriptCount(GameObject go) => go.Components.Count(component => component is null);
    }
}

namespace UnityEditor.SceneManagement
{
    /// <summary>Opens scenes in the editor.</summary>
    public sealed class EditorSceneManager : SceneManager
    {
        /// <summary>Opens a scene in place of the present one.</summary>
        public static Scene OpenScene(string scenePath)
        {
            World.Load(Path.GetFileNameWithoutExtension(scenePath), World.InProject(scenePath));
            return GetActiveScene();
        }
    }
}
