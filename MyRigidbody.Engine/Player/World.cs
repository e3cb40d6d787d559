using System.Collections.Generic;
using System.IO;
using System.Linq;
using System.Reflection;
using UnityEngine;

namespace RigidBodyDynamics.Engine
{
    /// <summary>All objects: a new world for every test.</summary>
    public static class World
    {
        private static readonly List<Object> Doomed = new List<Object>();
        private static string _sceneToLoad;

        /// <summary>True in play mode.</summary>
        public static bool IsPlaying { get; private set; }

        /// <summary>The name of the scene; empty if none has been loaded.</summary>
        public static string SceneName { get; private set; }

        /// <summary>The folder to which the program may write; deleted with the world.</summary>
        public static string Folder { get; private set; }

        public static int ScreenWidth { get; set; }

        public static int ScreenHeight { get; set; }

        /// <summary>The language of the system.</summary>
        public static SystemLanguage Language { get; set; } = SystemLanguage.English;

        /// <summary>The scenes; null where there are none.</summary>
        internal static IScenes Scenes { get; set; }

        /// <summary>The objects, in the order of the hierarchy.</summary>
        internal static List<GameObject> Objects { get; } = new List<GameObject>();

        /// <summary>The scripts in their order of execution, those of equal order by creation.</summary>
        internal static List<MonoBehaviour> Scripts { get; } = new List<MonoBehaviour>();

        /// <summary>An empty world, in play mode or in the editor.</summary>
        public static void Begin(bool isPlaying)
        {
            End();
            IsPlaying = isPlaying;
            SceneName = string.Empty;
            Folder = Path.Combine(Path.GetTempPath(), "unity stubs " + System.Guid.NewGuid().ToString("N"));
            ScreenWidth = 1280;
            ScreenHeight = 720;
            Clock.Reset();
            Keys.Reset();
            Coroutines.Reset();
            Gui.Reset();
            Physics.Reset();
            UnityConsole.Clear();
            Random.InitState(0);
            if (isPlaying)
                Messages.CallInitializers();
        }

        /// <summary>Destroys all objects, without messages to their scripts.</summary>
        public static void End()
        {
            foreach (GameObject left in Objects)
                left.IsDestroyed = true;

            Objects.Clear();
            Scripts.Clear();
            Doomed.Clear();
            Messages.Forget();
            _sceneToLoad = null;
            if (Folder != null && Directory.Exists(Folder))
                Directory.Delete(Folder, recursive: true);
        }

        /// <summary>True while the objects of a scene are created and woken.</summary>
        internal static bool IsLoading { get; private set; }

        internal static void Add(Object made)
        {
            if (made is GameObject holder)
                Objects.Add(holder);
            else if (made is MonoBehaviour script)
                Scripts.Insert(Scripts.FindLastIndex(other => Order(other) <= Order(script)) + 1, script);
        }

        private static int Order(MonoBehaviour script) =>
            script.GetType().GetCustomAttribute<DefaultExecutionOrder>()?.order ?? 0;

        internal static void DestroyLater(Object obj) => Doomed.Add(obj);

        internal static void DestroyDoomed()
        {
            foreach (Object obj in Doomed.ToArray())
                Destroy(obj);

            Doomed.Clear();
        }

        internal static void Destroy(Object obj)
        {
            if (obj is GameObject holder && holder)
            {
                for (int i = holder.transform.childCount - 1; i >= 0; i--)
                    Destroy(holder.transform.GetChild(i).gameObject);

                foreach (Component component in holder.Components.Where(c => !(c is null)).ToArray())
                    Destroy(component);

                if (holder.transform.parent is Transform parent)
                    holder.transform.SetParent(null);

                Objects.Remove(holder);
                holder.transform.IsDestroyed = true;
            }
            else if (obj is MonoBehaviour script && script)
            {
                script.End();
                Scripts.Remove(script);
            }

            if (obj is Transform)
                return;

            (obj as Component)?.gameObject.Detach((Component)obj);
            obj.IsDestroyed = true;
        }

        internal static string InProject(string path) => Scenes == null ? path : Scenes.InProject(path);

        internal static void LoadWithNextFrame(string sceneName) => _sceneToLoad = sceneName;

        internal static void LoadIfDue()
        {
            if (_sceneToLoad == null)
                return;

            string name = _sceneToLoad;
            _sceneToLoad = null;
            Load(name, (Scenes ?? throw new FileNotFoundException("Scene '" + name + "' couldn't be loaded")).PathOf(name));
        }

        /// <summary>Replaces the present scene.</summary>
        internal static void Load(string name, string path)
        {
            foreach (GameObject root in Objects.Where(o => o.transform.parent == null && !o.Survives).ToArray())
                Destroy(root);

            SceneName = name;
            IsLoading = true;
            try
            {
                Scenes.Load(path);
            }
            finally
            {
                IsLoading = false;
            }
        }
    }
}
