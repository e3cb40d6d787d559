using System.Text.RegularExpressions;
using NUnit.Framework;
using static RigidBodyDynamics.Tests.UnityProject.Change;

namespace RigidBodyDynamics.Tests.UnityProject;

/// <summary>Scenes and materials that differ from what Unity 2019.4 writes.</summary>
internal static partial class BrokenScenes
{
    private const string Blue = Assets + "Materials/Blue.mat";

    public static IEnumerable<TestCaseData> All() => [.. Texts(), .. Fields(), .. References(), .. Objects()];

    private static IEnumerable<TestCaseData> Texts() =>
    [
        Found("another version of YAML", Replace(LabScene, "%YAML 1.1", "%YAML 1.2"), "must begin with %YAML 1.1"),
        Found("a carriage return", Replace(LabScene, "\n", "\r\n"), "carriage return"),
        Found("a byte order mark", Real.With(LabScene, "\uFEFF" + Text(LabScene)), "byte order mark"),
        Found("no line feed at the end", Real.With(LabScene, Text(LabScene).TrimEnd()), "no line feed"),
        Found("a field twice", Replace(LabScene, "  m_Drag: 0\n", "  m_Drag: 0\n  m_Drag: 1\n"), "m_Drag"),
        Found("an object of no class", Replace(LabScene, "BoxCollider:\n", "BoxCollider: 1\n"), "Lab.unity: object &"),
    ];

    private static IEnumerable<TestCaseData> Fields() =>
    [
        Found("a missing field", Replace(LabScene, "  m_RayTracingMode: 2\n", ""), "MeshRenderer: lacks m_RayTracingMode"),
        Found(
            "a field of 2020",
            Replace(LabScene, "  m_Children:", "  m_ConstrainProportionsScale: 0\n  m_Children:"),
            "m_ConstrainProportionsScale, which Unity 2019.4 does not write"),
        Found("a field of 2020 in a material", Replace(Blue, "    m_Colors:", "    m_Ints: []\n    m_Colors:"), "m_Ints, which Unity 2019.4 does not write"),
        Found(
            "fields in another order",
            Replace(LabScene, "  m_Drag: 0\n  m_AngularDrag: 0.05\n", "  m_AngularDrag: 0.05\n  m_Drag: 0\n"),
            "Rigidbody: its fields stand in another order"),
        Found("a light of 2020", Replace(LabScene, "serializedVersion: 10\n", "serializedVersion: 11\n"), "Light.serializedVersion: 11 is not =10"),
        Found("a light map of 2020", Replace(LabScene, "serializedVersion: 11\n", "serializedVersion: 12\n"), "LightmapSettings.serializedVersion"),
        Found("a material of 2021", Replace(Blue, "serializedVersion: 6\n", "serializedVersion: 8\n"), "Material.serializedVersion"),
        Found("a colour more", Replace(Blue, "    - _Color:", "    - _EmissionColor: {r: 0, g: 0, b: 0, a: 1}\n    - _Color:"), "m_Colors[0]: lacks _Color"),
        Found("a text for a number", Replace(LabScene, "m_Mass: 1\n", "m_Mass: one\n"), "m_Mass: one is not float"),
        Found("a true for a 1", Replace(LabScene, "m_IsActive: 1\n", "m_IsActive: true\n"), "m_IsActive: true is not bool"),
        Found("a vector without z", Replace(LabScene, "m_Size: {x: 1, y: 1, z: 1}", "m_Size: {x: 1, y: 1}"), "m_Size"),
        Found(
            "a rotation that is none",
            Replace(SlabScene, "m_LocalRotation: {x: 0, y: 0, z: 0, w: 1}", "m_LocalRotation: {x: 0, y: 0, z: 0, w: 0.9}"),
            "is not rotation"),
        Found(
            "a rotation unlike its angles",
            Replace(SlabScene, "m_LocalEulerAnglesHint: {x: 0, y: 0, z: 0}", "m_LocalEulerAnglesHint: {x: 0, y: 1, z: 0}"),
            "m_LocalEulerAnglesHint"),
    ];

    private static IEnumerable<TestCaseData> References() =>
    [
        Found("an object that is not there", Replace(LabScene, "m_Sun: {fileID: 0}", "m_Sun: {fileID: 77}"), "refers to &77, which is not in the file"),
        Found("a component that is not there", Replace(LabScene, "- component: {fileID: ", "- component: {fileID: 7"), "which is not in the file"),
        Found("an object of another class", Replace(LabScene, "m_Father: {fileID: 0}", "m_Father: {fileID: 1}"), "not to a Transform"),
        Found("an unknown GUID", Replace(LabScene, "m_Script: {fileID: 11500000, guid: ", "m_Script: {fileID: 11500000, guid: 0"), "which no asset has"),
        Found("a GUID in capitals", Replace(LabScene, Guid(Sources + "MyRigidbody.cs"), Guid(Sources + "MyRigidbody.cs").ToUpperInvariant()), "which no asset has"),
        Found("a material for a script", Replace(LabScene, Guid(Sources + "MyRigidbody.cs"), Guid(Blue)), "Blue.mat, not to a .cs"),
        Found("a script that is no component", Replace(LabScene, Guid(Sources + "Panel.cs"), Guid(Sources + "ToUnity.cs")), "has no script that Unity would find"),
        Found("a script by the wrong number", Replace(LabScene, "{fileID: 11500000, ", "{fileID: 2100000, "), "has fileID 11500000 and type 3"),
        Found("a material of the wrong type", Replace(LabScene, "type: 2}", "type: 3}"), "has fileID 2100000 and type 2"),
        Found("a cylinder for a cube", Replace(LabScene, "fileID: 10202", "fileID: 10206"), "should be {fileID: 10202"),
        Found(
            "a cube from elsewhere",
            Replace(LabScene, "guid: 0000000000000000e000000000000000, type: 0}\n---", "guid: 0000000000000000f000000000000000, type: 0}\n---"),
            "should be {fileID: 10202"),
        Found("a shader of the built-in pipeline", Replace(Blue, "{fileID: 4800000, guid: " + Guid(Assets + "Materials/Matt.shader") + ", type: 3}", "{fileID: 46, guid: 0000000000000000f000000000000000, type: 0}"), "which no asset has"),
        Found("a shader by the number of a script", Replace(Blue, "fileID: 4800000", "fileID: 11500000"), "has fileID 4800000 and type 3"),
        Found("a prefab", Replace(LabScene, "m_PrefabInstance: {fileID: 0}", "m_PrefabInstance: {fileID: 1}"), "should refer to nothing"),
        Found("a reference that is none", Replace(LabScene, "m_Icon: {fileID: 0}", "m_Icon: 0"), "is not a reference"),
    ];

    private static IEnumerable<TestCaseData> Objects() =>
    [
        Found("a class that is not used", Replace(LabScene, "--- !u!65 ", "--- !u!64 "), "class 64 is none"),
        Found("the number of another class", Replace(LabScene, "--- !u!54 ", "--- !u!65 "), "class 65 is BoxCollider, not Rigidbody"),
        Found("a number twice", Replace(LabScene, "--- !u!157 &3", "--- !u!157 &2"), "2 objects are &2"),
        Found("the number zero", Replace(LabScene, "--- !u!157 &3", "--- !u!157 &0"), "1 objects are &0"),
        Found("no light map settings", Real.With(LabScene, LightMap().Replace(Text(LabScene), "---")), "must begin with the settings &1 to &4"),
        Found("objects in another order", Replace(LabScene, "--- !u!196 &4", "--- !u!196 &4444444444"), "in the order of their fileIDs"),
    ];

    [GeneratedRegex(@"--- !u!157(.|\n)*?---")]
    private static partial Regex LightMap();
}
