using System.Text.RegularExpressions;
using NUnit.Framework;
using RigidBodyDynamics.Lab.Package;
using RigidBodyDynamics.Tests.Repository;

namespace RigidBodyDynamics.Tests.Package;

/// <summary>
/// docs/unity-members.md lists every member of the engine that the packages touch, with the version that brought it and the one that made it obsolete. A new one is
/// seen here: MYRIGIDBODY_WRITE=1 writes its row, and somebody has to look its versions up.
/// </summary>
public sealed partial class EngineMemberTests
{
    private const string Page = "docs/unity-members.md", Unknown = "?";

    private static readonly string[] Oldest = ["UNITY_EDITOR", "UNITY_2019_3_OR_NEWER", "UNITY_2019_4_OR_NEWER", "ENABLE_LEGACY_INPUT_MANAGER"];
    private static readonly string[] Newest =
        ["UNITY_EDITOR", "UNITY_2019_3_OR_NEWER", "UNITY_2019_4_OR_NEWER", "UNITY_2022_2_OR_NEWER", "UNITY_6000_0_OR_NEWER", "ENABLE_INPUT_SYSTEM"];

    [Test]
    public void Page_lists_every_member_that_is_touched_and_no_other()
    {
        SortedSet<string> touched = new(Members(Oldest).Concat(Members(Newest)), StringComparer.Ordinal);
        if (Environment.GetEnvironmentVariable("MYRIGIDBODY_WRITE") == "1")
            Write(touched);

        Assert.That(Rows().Keys, Is.EquivalentTo(touched));
        Assert.That(Rows().Where(row => row.Value.Since == Unknown).Select(row => row.Key), Is.Empty);
    }

    // nothing that every version has takes their place; a pragma says so where each is used
    private static readonly string[] ObsoleteAndUsed = ["UnityEditor.AssetDatabase.ExportPackage", "UnityEditor.Compilation.AssemblyBuilder"];

    [Test]
    public void What_2019_has_not_is_touched_behind_a_symbol_alone()
    {
        Dictionary<string, (string Since, string Obsolete)> rows = Rows();
        Assert.That(Members(Oldest).Where(member => rows[member].Since != "2019.4"), Is.Empty);
        Assert.That(Members(Newest).Where(member => rows[member].Obsolete.Length > 0), Is.EquivalentTo(ObsoleteAndUsed));
    }

    private static IEnumerable<string> Members(string[] symbols) =>
        new UnityCompiler([.. Checkout.Gather(Root.Path), .. Checkout.GatherStarter(Root.Path)], symbols).EngineMembers().Distinct();

    private static Dictionary<string, (string Since, string Obsolete)> Rows() => File.Exists(Root.File(Page))
        ? Row().Matches(File.ReadAllText(Root.File(Page))).ToDictionary(row => row.Groups[1].Value, row => (row.Groups[2].Value.Trim(), row.Groups[3].Value.Trim()))
        : [];

    private static void Write(SortedSet<string> touched)
    {
        Dictionary<string, (string Since, string Obsolete)> known = Rows();
        string page = """
            # What the packages use of Unity

            Every member of the engine and of the editor that a script of the two packages names, with the version from which on it is there (2019.4: then or earlier) and the
            one that made it obsolete. What 2019.4 has not, and what a later version made obsolete, stands behind a symbol, nearly all of it in `EngineVersions.cs`; two are
            used though they are obsolete (a type's mark counts for its members), because nothing that every version has takes their place; a pragma says so there. A test
            writes the list (`MYRIGIDBODY_WRITE=1 dotnet test -c Release tests/MyRigidbody.Tests --filter EngineMember`) and fails where a member is new and nobody has looked its versions up.

            How it was checked: each name was looked up, public or protected and with its `Obsolete` attribute, in the C# sources that Unity publishes
            (`UnityCsReference`), in the newest of each of 23 minor versions from 2018.4 to 6000.7.0a1. All 268 of the engine and the editor are in every version from 2019.4,
            or from the one in the table, up to 6000.7; all but one (`SubsystemRegistration`, 2019.2) of those from 2019.4 are in 2018.4 too. The nine of the Input System were looked up in
            its 1.0.0 and 1.11.2. Whether an overload is obsolete was looked at where some were: `GetAssetPath` by number (6000.3), `ObjectField` without its last argument and
            `AddComponent` by a string; the scripts use none of them.

            Not checked: the types of parameters and results; what the members do ([stand-in.md](stand-in.md) has that); versions after 6000.7.0a1, among them 7.0;
            whatever an editor itself would say.

            | member | since | obsolete since |
            | --- | --- | --- |

            """;
        File.WriteAllText(Root.File(Page), page + string.Concat(touched.Select(member =>
        {
            (string since, string obsolete) = known.GetValueOrDefault(member, (Unknown, ""));
            return $"| `{member}` | {since} | {obsolete} |\n";
        })));
    }

    [GeneratedRegex(@"^\| `([\w.]+)` \| ([^|]*)\| ([^|]*)\|$", RegexOptions.Multiline)]
    private static partial Regex Row();
}
