using System;
using System.Collections.Generic;
using System.IO;
using System.Linq;
using RigidBodyDynamics.UnityFiles;
using UnityEngine;
using YamlDotNet.RepresentationModel;

namespace RigidBodyDynamics.Engine
{
    /// <summary>Makes the objects of a scene file, then wakes them.</summary>
    internal sealed class SceneLoader
    {
        /// <summary>The scenes of the repository's project.</summary>
        public static IScenes Scenes { get; } = new OfTheProject();

        private static readonly Lazy<AssetIndex> Index = new Lazy<AssetIndex>(() => new AssetIndex(new[] { InProject("Assets") }));

        private readonly UnityFile _file;
        private readonly Dictionary<long, GameObject> _objects = new Dictionary<long, GameObject>();
        private readonly Dictionary<long, Component> _components = new Dictionary<long, Component>();

        private SceneLoader(string path) => _file = UnityFile.Read(path);

        /// <summary>Where the project has a scene of that name.</summary>
        public static string PathOf(string scene) =>
            Directory.EnumerateFiles(InProject("Assets"), scene + ".unity", SearchOption.AllDirectories).SingleOrDefault()
            ?? throw new FileNotFoundException("Scene '" + scene + "' couldn't be loaded");

        /// <summary>A path of the project, which begins with Assets.</summary>
        public static string InProject(string path) => Path.Combine(Root.Path, "UnityProject", path);

        public static void Load(string path) => new SceneLoader(path).Load();

        private void Load()
        {
            // parents before children, and siblings in their order: so the world has them as the hierarchy shows them
            foreach (UnityObject root in Transforms(0))
                Make(root, null);

            foreach (UnityObject written in _file.Objects.Where(o => _components.ContainsKey(o.FileId)))
                new SceneFields(written, _components).Fill(_components[written.FileId]);

            foreach (GameObject made in _objects.Values)
            {
                foreach (MonoBehaviour script in made.GetComponents<MonoBehaviour>())
                {
                    if (!World.IsPlaying)
                        Messages.Validate(script);

                    script.Settle();
                }
            }
        }

        private IEnumerable<UnityObject> Transforms(long father) =>
            from o in _file.Objects
            where o.TypeName == "Transform" && Yaml.Reference(o["m_Father"]) == father
            orderby Yaml.Number(o["m_RootOrder"])
            select o;

        private void Make(UnityObject transform, GameObject parent)
        {
            UnityObject written = Find(Yaml.Reference(transform["m_GameObject"]));
            GameObject made = new GameObject(Yaml.Text(written["m_Name"]), isActive: Yaml.Number(written["m_IsActive"]) != 0) { tag = written["m_TagString"] == null ? "Untagged" : Yaml.Text(written["m_TagString"]) };
            made.transform.SetParent(parent?.transform, false);
            _objects.Add(written.FileId, made);
            _components.Add(transform.FileId, made.transform);
            foreach (YamlNode entry in (YamlSequenceNode)written["m_Component"])
                Attach(made, Find(Yaml.Reference(entry["component"])));

            foreach (UnityObject child in Transforms(transform.FileId))
                Make(child, made);
        }

        private void Attach(GameObject holder, UnityObject part)
        {
            if (part.TypeName == "Transform")
                return;

            Type type = part.TypeName == "MonoBehaviour" ? Script(part) : typeof(GameObject).Assembly.GetType("UnityEngine." + part.TypeName, throwOnError: true);
            if (type != null)
            {
                _components.Add(part.FileId, holder.Attach(type));
                return;
            }

            holder.AttachMissingScript();
            Debug.LogError("The referenced script on this Behaviour (Game Object '" + holder.name + "') is missing!", holder);
        }

        private UnityObject Find(long fileId) =>
            _file.Objects.SingleOrDefault(o => o.FileId == fileId) ?? throw new FormatException(_file.Path + ": there is no object &" + fileId);

        // the file of a script has the name of its class; those that students write in have no namespace
        private static Type Script(UnityObject part)
        {
            string path = Index.Value.Find(Yaml.Text(part["m_Script"]["guid"]));
            string name = Path.GetFileNameWithoutExtension(path);
            return path == null ? null : Array.Find(
                typeof(SceneLoader).Assembly.GetTypes(),
                type => type.Name == name && type.Namespace == null == path.Contains("MyRigidbodyStarter") && typeof(MonoBehaviour).IsAssignableFrom(type));
        }

        private sealed class OfTheProject : IScenes
        {
            public string PathOf(string scene) => SceneLoader.PathOf(scene);

            public string InProject(string path) => SceneLoader.InProject(path);

            public void Load(string path) => SceneLoader.Load(path);
        }
    }
}
