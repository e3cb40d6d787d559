using System.Globalization;
using UnityEngine;
using YamlDotNet.RepresentationModel;

namespace RigidBodyDynamics.Engine
{
    /// <summary>Reads the values of a scene file.</summary>
    internal static class Yaml
    {
        public static string Text(YamlNode node) => ((YamlScalarNode)node).Value;

        public static double Number(YamlNode node) => double.Parse(Text(node), CultureInfo.InvariantCulture);

        public static Vector3 Vector(YamlNode node) => new Vector3(Single(node["x"]), Single(node["y"]), Single(node["z"]));

        public static Quaternion Turn(YamlNode node) => new Quaternion(Single(node["x"]), Single(node["y"]), Single(node["z"]), Single(node["w"]));

        /// <summary>The object that is referred to; 0 for none.</summary>
        public static long Reference(YamlNode node) => long.Parse(Text(node["fileID"]), CultureInfo.InvariantCulture);

        public static float Single(YamlNode node) => float.Parse(Text(node), CultureInfo.InvariantCulture);
    }
}
