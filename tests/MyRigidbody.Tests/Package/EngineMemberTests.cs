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

    [Test]
    public void What_2019_has_not_is_touched_behind_a_symbol_alone()
    {
        Dictionary<string, (string Since, string Obsolete)> rows = Rows();
        Assert.That(Members(Oldest).Where(member => rows[member].Since != "2019.4"), Is.Empty);
        Assert.That(Members(Newest).Where(member => rows[member].Obsolete.Length > 0), Is.Empty);
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
            one that made it obsolete; by Unity's scripting reference. What 2019.4 has not, and what a later version made obsolete, stands behind a symbol, nearly all of it in
            `EngineVersions.cs`. A test writes the list (`MYRIGIDBODY_WRITE=1 dotnet test -c Release tests/MyRigidbody.Tests --filter EngineMembers`) and fails where a member
            is new and nobody has looked its versions up.

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
