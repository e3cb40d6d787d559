using System;
using System.IO;
using System.Linq;
using RigidBodyDynamics.Engine;
using RigidBodyDynamics.UnityFiles;

namespace UnityEditor
{
    /// <summary>A script as an asset.</summary>
    public sealed class MonoScript : UnityEngine.Object
    {
        internal string Path { get; set; }

        /// <summary>Its class, if the project compiles: the one that is called like the file, without a namespace first.</summary>
        public Type GetClass() => typeof(MonoScript).Assembly.GetTypes().Where(type => type.Name == System.IO.Path.GetFileNameWithoutExtension(Path))
            .OrderBy(type => Path.Contains("Starter") == (type.Namespace == null) ? 0 : 1).FirstOrDefault();
    }

    /// <summary>The files of the repository's project as assets.</summary>
    public sealed class AssetDatabase
    {
        private static readonly Lazy<AssetIndex> Index = new Lazy<AssetIndex>(() => new AssetIndex(new[] { SceneLoader.InProject("Assets") }));

        /// <summary>What was exported last: the assets and the file.</summary>
        internal static (string[] Assets, string File) Exported { get; private set; }

        public static string[] FindAssets(string filter) => FindAssets(filter, new[] { "Assets" });

        /// <summary>GUIDs of the assets below some folders; of a filter the first word is a part of the name.</summary>
        public static string[] FindAssets(string filter, string[] searchInFolders)
        {
            string name = filter.Split(' ')[0];
            bool isScript = filter.EndsWith("t:MonoScript", StringComparison.Ordinal);
            return Index.Value.Paths.Select(asset => (asset.Key, Path: InAssets(asset.Value)))
                .Where(asset => searchInFolders.Any(folder => asset.Path.StartsWith(folder + "/", StringComparison.Ordinal)))
                .Where(asset => Path.GetFileNameWithoutExtension(asset.Path).Contains(name) && (!isScript || asset.Path.EndsWith(".cs", StringComparison.Ordinal)))
                .OrderBy(asset => asset.Path, StringComparer.Ordinal).Select(asset => asset.Key).ToArray();
        }

        public static string GUIDToAssetPath(string guid) => InAssets(Index.Value.Find(guid));

        public static T LoadAssetAtPath<T>(string assetPath) where T : UnityEngine.Object =>
            (T)(UnityEngine.Object)new MonoScript { name = Path.GetFileNameWithoutExtension(assetPath), Path = assetPath };

        public static string GetAssetPath(UnityEngine.Object assetObject) => ((MonoScript)assetObject).Path;

#if UNITY_6000_6_OR_NEWER
        [Obsolete("as in Unity since 6000.6, which has AssetPackage.Package.Export")]
#endif
        public static void ExportPackage(string[] assetPathNames, string fileName, ExportPackageOptions flags) => Exported = (assetPathNames, fileName);

        private static string InAssets(string path) => Path.GetRelativePath(SceneLoader.InProject(string.Empty), path).Replace('\\', '/');
    }

    /// <summary>What goes into a package besides what is named.</summary>
    [Flags]
    public enum ExportPackageOptions
    {
        Default = 0,
        Interactive = 1,
        Recurse = 2,
        IncludeDependencies = 4,
    }
}
