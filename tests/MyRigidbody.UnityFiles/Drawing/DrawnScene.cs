using System.Numerics;
using RigidBodyDynamics.UnityFiles.Shading;
using YamlDotNet.RepresentationModel;

namespace RigidBodyDynamics.UnityFiles.Drawing;

/// <summary>The picture of a scene through its camera: cubes and the background.</summary>
/// <param name="View">The main camera.</param>
/// <param name="Shading">How the shader of the cubes' materials shows a surface; it knows no lights.</param>
/// <param name="Cubes">In the order of the hierarchy.</param>
public sealed record DrawnScene(Viewpoint View, MattShading Shading, IReadOnlyList<DrawnCube> Cubes)
{
    private const int GameObjectId = 1, TransformId = 4, CameraId = 20, RendererId = 23;

    /// <summary>Reads a scene; other poses may be given for some of its objects, by their names.</summary>
    /// <exception cref="FormatException">It is not a scene as Unity writes it, or has more than this can draw.</exception>
    public static DrawnScene Read(string path, IReadOnlyDictionary<string, Pose>? poses = null)
    {
        UnityFile file = UnityFile.Read(path);
        AssetIndex assets = new(AssetsFolder(path));
        Graph graph = new(file, poses ?? new Dictionary<string, Pose>());

        UnityObject camera = file.Objects.Single(o => o.ClassId == CameraId);
        (UnityObject Object, UnityObject Material)[] renderers = [.. file.Objects.Where(o => o.ClassId == RendererId).Select(o => (o, Material(o, assets)))];
        (Vector3 position, Quaternion rotation) = graph.Pose(camera);
        Viewpoint view = new(
            position, rotation, camera["field of view"]!.Number(), camera["near clip plane"]!.Number(), camera["m_BackGroundColor"]!.Color());
        return new DrawnScene(
            view,
            renderers.Select(renderer => ShadingOf(renderer.Material, assets)).Distinct().Single(),
            [.. renderers.Select(renderer => graph.Cube(renderer.Object, Color(renderer.Material))).OrderBy(cube => cube.Order).Select(cube => cube.Cube)]);
    }

    private static string AssetsFolder(string scene)
    {
        DirectoryInfo? folder = new FileInfo(scene).Directory;
        while (folder != null && folder.Name != "Assets")
            folder = folder.Parent;

        return folder?.FullName ?? throw new FormatException($"{scene}: is not in a folder Assets");
    }

    private static UnityObject Material(UnityObject renderer, AssetIndex assets) =>
        UnityFile.Read(Asset(renderer["m_Materials"]!.List()[0], assets)).Objects[0];

    private static MattShading ShadingOf(UnityObject material, AssetIndex assets) =>
        MattShading.Of(ShaderFile.Parse(File.ReadAllText(Asset(material["m_Shader"]!, assets))));

    private static Vector3 Color(UnityObject material) => material["m_SavedProperties"].Field("m_Colors").List()
        .Cast<YamlMappingNode>().Single(color => color.Children[0].Key.Text() == "_Color").Children[0].Value.Color();

    private static string Asset(YamlNode reference, AssetIndex assets)
    {
        string guid = reference.Field("guid").Text();
        return assets.Find(guid) ?? throw new FormatException($"no asset has the GUID {guid}");
    }

    /// <summary>The parent of each object.</summary>
    private sealed class Graph(UnityFile file, IReadOnlyDictionary<string, Pose> poses)
    {
        private readonly Dictionary<long, UnityObject> _objects = file.Objects.ToDictionary(o => o.FileId);

        public (Vector3 Position, Quaternion Rotation) Pose(UnityObject component)
        {
            Matrix4x4.Decompose(World(TransformOf(Owner(component))), out _, out Quaternion rotation, out Vector3 position);
            return (position, rotation);
        }

        public (DrawnCube Cube, string Order) Cube(UnityObject renderer, Vector3 color)
        {
            UnityObject owner = Owner(renderer), transform = TransformOf(owner);
            UnityObject? father = Father(transform);
            return (new DrawnCube(Name(owner), father == null ? null : Name(Owner(father)), World(transform), color), Order(transform));
        }

        private UnityObject Owner(UnityObject component) => _objects[component["m_GameObject"]!.FileId()];

        private UnityObject TransformOf(UnityObject owner) => owner.ClassId == GameObjectId
            ? _objects[owner["m_Component"]!.List()[0].Field("component").FileId()]
            : throw new FormatException($"&{owner.FileId} is no GameObject");

        private UnityObject? Father(UnityObject transform) => transform.ClassId == TransformId
            ? _objects.GetValueOrDefault(transform["m_Father"]!.FileId())
            : throw new FormatException($"&{transform.FileId} is no Transform");

        private static string Name(UnityObject owner) => owner["m_Name"]!.Text();

        private string Order(UnityObject transform) =>
            (Father(transform) is UnityObject father ? Order(father) + "." : string.Empty) + transform["m_RootOrder"]!.Text().PadLeft(4, '0');

        private Matrix4x4 World(UnityObject transform)
        {
            Pose pose = poses.GetValueOrDefault(Name(Owner(transform))) ?? new Pose(transform["m_LocalPosition"]!.Vector(), transform["m_LocalRotation"]!.Rotation());
            Matrix4x4 local = Matrix4x4.CreateScale(transform["m_LocalScale"]!.Vector())
                * Matrix4x4.CreateFromQuaternion(pose.Rotation) * Matrix4x4.CreateTranslation(pose.Position);
            return Father(transform) is UnityObject father ? local * World(father) : local;
        }
    }
}
