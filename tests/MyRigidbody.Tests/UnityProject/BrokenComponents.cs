using System.Text.RegularExpressions;
using NUnit.Framework;
using RigidBodyDynamics.UnityFiles;
using RigidBodyDynamics.UnityFiles.Checks;
using static RigidBodyDynamics.Tests.UnityProject.Change;

namespace RigidBodyDynamics.Tests.UnityProject;

/// <summary>Objects with contradictory references, and components whose scripts say otherwise.</summary>
internal static class BrokenComponents
{
    private static readonly UnityFile Scene = UnityFile.Parse(LabScene, Text(LabScene));
    private static readonly string FirstObject = Ids("GameObject")[0], SecondObject = Ids("GameObject")[1], RigidbodyId = Ids("Rigidbody")[0];
    private static readonly string Entry = $"  - component: {{fileID: {RigidbodyId}}}\n";

    public static IEnumerable<TestCaseData> All() => [.. Objects(), .. Fathers(), .. Cameras(), .. Fields(), .. Classes()];

    private static IEnumerable<TestCaseData> Objects() =>
    [
        Found(
            "a component that points elsewhere",
            Replace(LabScene, $"m_GameObject: {{fileID: {FirstObject}}}", $"m_GameObject: {{fileID: {SecondObject}}}"),
            $"belongs to &{SecondObject}, but &{FirstObject} lists it"),
        Found("a component that nobody lists", Replace(LabScene, Entry, ""), "its GameObject lists it 0 times"),
        Found("a component listed twice", Replace(LabScene, Entry, Entry + Entry), "lists it 2 times"),
        Found("a Transform that is not first", Edit("(  - component: .*\n)(  - component: .*\n)", "$2$1"), "not one Transform, and that first"),
        Found(
            "no Rigidbody where a script requires one",
            Edit($"{Entry}|--- !u!54 &{RigidbodyId}\n(  .*\n|Rigidbody:\n)*", ""),
            "has a DefaultRigidbody but no Rigidbody"),
        Found(
            "two of a component that stands alone",
            Replace(LabScene, Guid(Sources + "MotionGizmos.cs"), Guid(Sources + "MyRigidbody.cs")),
            "has 2 of MyRigidbody, which stands alone"),
        Found("two colliders", Edit("--- !u!54 (.*)\nRigidbody:", "--- !u!65 $1\nBoxCollider:"), "has 2 of BoxCollider"),
    ];

    private static IEnumerable<TestCaseData> Fathers() =>
    [
        Found("a father who does not know", Edit(@"m_Children:\n  - .*\n", "m_Children: []\n"), "does not list it among its children"),
        Found("a child with another father", Edit(@"m_Father: \{fileID: [1-9]\d*\}", "m_Father: {fileID: 0}"), "has another father"),
        Found("a place taken twice", Replace(LabScene, "m_RootOrder: 3", "m_RootOrder: 2"), "m_RootOrder is 2, where 3 is missing or taken twice"),
        Found("a child in another place", Edit(@"(m_Father: \{fileID: [1-9]\d*\}\n  m_RootOrder: )0", "${1}1"), "m_RootOrder is 1, but it is child 0"),
    ];

    private static IEnumerable<TestCaseData> Cameras() =>
    [
        Found("a camera without its tag", Replace(LabScene, "m_TagString: MainCamera", "m_TagString: Untagged"), "tagged MainCamera"),
        Found("a second main camera", Replace(LabScene, "m_TagString: Untagged", "m_TagString: MainCamera"), "more than one object is tagged MainCamera"),
        Found("two audio listeners", Real.With(LabScene, Text(LabScene) + Second(81, "AudioListener")), "has 2 audio listeners"),
        Found("two cameras", Real.With(LabScene, Text(LabScene) + Second(20, "Camera")), "has 2 cameras"),
    ];

    private static IEnumerable<TestCaseData> Fields() =>
    [
        Found("a field of a script is missing", Replace(LabScene, "  damping: 0\n", ""), "MonoBehaviour: lacks damping"),
        Found("a field that the script has not", Replace(LabScene, "  damping: 0\n", "  damping: 0\n  dampening: 0\n"), "has dampening"),
        Found(
            "fields of a script in another order",
            Replace(LabScene, "  useGravity: 0\n  readsKeys: 1\n", "  readsKeys: 1\n  useGravity: 0\n"),
            "in another order"),
        Found("a name that the enum has not", Replace(LabScene, "  inertia: 0\n", "  inertia: 3\n"), "inertia: 3 is not one of 3"),
        Found("a name for a number", Replace(LabScene, "  inertia: 0\n", "  inertia: LabVertices\n"), "inertia: LabVertices is not one of 3"),
        Found("a number for a vector", Replace(LabScene, "  startSpin: {x: 0, y: 0, z: 0}\n", "  startSpin: 0\n"), "startSpin"),
        Found("a partner that is a Rigidbody", Edit(@"comparedWith: .*", $"comparedWith: {{fileID: {RigidbodyId}}}"), "not to a DefaultRigidbody"),
        Found("a field that is not public any more", Replace(Sources + "MyRigidbody.cs", "public bool readsKeys", "private bool readsKeys"), "has readsKeys"),
        Found(
            "a field that is new in the script",
            Replace(Sources + "MotionGizmos.cs", "public float spinLength", "public int width;\n        public float spinLength"),
            "lacks width"),
        Found(
            "a field of a type unknown here",
            Replace(Sources + "MotionGizmos.cs", "public float spinLength", "public Gradient spinLength"),
            "does not know how Unity writes a field of type Gradient"),
    ];

    private static IEnumerable<TestCaseData> Classes() =>
    [
        Found("a class called unlike its file", Replace(Sources + "Panel.cs", "class Panel", "class Board"), "class Board is a component"),
        Found("a script that has no component any more", Replace(Sources + "Panel.cs", ": MonoBehaviour", ""), "has no script that Unity would find"),
    ];

    private static string[] Ids(string type) => [.. Scene.Objects.Where(o => o.TypeName == type).Select(o => $"{o.FileId}")];

    private static ProjectFiles Edit(string pattern, string other)
    {
        string edited = Regex.Replace(Text(LabScene), pattern, other);
        return edited != Text(LabScene) ? Real.With(LabScene, edited) : throw new ArgumentException($"{LabScene} has no {pattern}", nameof(pattern));
    }

    /// <summary>An object like the first of its class, with another number.</summary>
    private static string Second(int classId, string type) =>
        Regex.Replace(Regex.Match(Text(LabScene), $"--- !u!{classId} &\\d+\n{type}:\n(  .*\n)*").Value, @"&\d+", "&4444444444");
}
