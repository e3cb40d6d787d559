using System;
using System.Linq;
using RigidBodyDynamics.Engine;

namespace UnityEngine.SceneManagement
{
    /// <summary>A scene that is loaded.</summary>
    public struct Scene
    {
        internal Scene(string name) => this.name = name;

        public string name { get; }

        public bool isLoaded => IsValid() && name == World.SceneName && !World.IsLoading;

        public int rootCount => GetRootGameObjects().Length;

        public bool IsValid() => name != null;

        /// <summary>In the order of the hierarchy. Not before the scene is loaded, because versions differ in what Awake gets.</summary>
        public GameObject[] GetRootGameObjects() => isLoaded
            ? World.Objects.Where(o => o.transform.parent == null && !o.Survives).ToArray()
            : throw new ArgumentException("The scene is not loaded.");
    }

    /// <summary>Loads scenes.</summary>
    public class SceneManager
    {
        public static Scene GetActiveScene() => new Scene(World.SceneName);

        /// <summary>Loads it with the next frame and destroys the objects of the present one.</summary>
        public static void LoadScene(string sceneName)
        {
            if (!World.IsPlaying)
                throw new InvalidOperationException("This cannot be used during edit mode.");

            World.LoadWithNextFrame(sceneName);
        }
    }
}
