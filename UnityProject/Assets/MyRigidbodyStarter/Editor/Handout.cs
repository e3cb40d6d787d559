using System;
using System.IO;
using System.Linq;
using UnityEditor;

namespace RigidBodyDynamics.Starter
{
    /// <summary>The assets of the starter: which script is the student's, and the contents of the package for submission.</summary>
    internal static class Handout
    {
        private const string Top = "Assets/MyRigidbodyStarter";

        /// <summary>The student's script: a MyRigidbody without a namespace, in any folder; null if there is none.</summary>
        public static MonoScript Script()
        {
            string[] found = AssetDatabase.FindAssets("MyRigidbody t:MonoScript").Select(AssetDatabase.GUIDToAssetPath)
                .Where(path => Path.GetFileName(path) == "MyRigidbody.cs").OrderBy(path => path.StartsWith(Top, StringComparison.Ordinal) ? 0 : 1).ToArray();
            return found.Select(AssetDatabase.LoadAssetAtPath<MonoScript>)
                .FirstOrDefault(script => script != null && (script.GetClass() == null || script.GetClass().Namespace == null));
        }

        /// <summary>学号_姓名.unitypackage, or null where one of the two is missing or has a character that is invalid in file names.</summary>
        public static string PackageName(string number, string name)
        {
            number = (number ?? string.Empty).Trim();
            name = (name ?? string.Empty).Trim();
            bool isSound = number.Length > 0 && name.Length > 0 && (number + name).IndexOfAny("\\/:*?\"<>|_\r\n\t".ToCharArray()) < 0;
            return isSound ? number + "_" + name + ".unitypackage" : null;
        }

        /// <summary>Writes the package into the folder of the project; the check window is not part of it.</summary>
        public static void Export(MonoScript script, string file)
        {
            string[] assets = AssetDatabase.FindAssets(string.Empty, new[] { Top }).Select(AssetDatabase.GUIDToAssetPath)
                .Concat(new[] { AssetDatabase.GetAssetPath(script) })
                .Where(path => !path.Contains("/Editor") && Path.GetExtension(path).Length > 0 && !path.EndsWith(".md", StringComparison.Ordinal)).Distinct().ToArray();
#pragma warning disable CS0618 // obsolete since Unity 6000.6; earlier versions have no replacement
            AssetDatabase.ExportPackage(assets, file, ExportPackageOptions.Default);
#pragma warning restore CS0618
            EditorUtility.RevealInFinder(file);
        }
    }
}
