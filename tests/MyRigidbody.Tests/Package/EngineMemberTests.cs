using System.Text.RegularExpressions;
using NUnit.Framework;
using RigidBodyDynamics.Lab.Package;
using RigidBodyDynamics.Tests.Repository;

namespace RigidBodyDynamics.Tests.Package;

/// <summary>
/// docs/unity-members.md lists every member of the engine that the packages use, with the version that added it and the one that made it obsolete. A new one
/// is found here: MYRIGIDBODY_WRITE=1 writes its row, and its versions must be looked up.
/// </summary>
public sealed partial class EngineMemberTests
{
    private const string Page = "docs/unity-members.md", InChinese = "docs/unity-members.zh.md", Unknown = "?";

    private static readonly Lazy<string[]> Oldest = new(() => Members("UNITY_EDITOR", "UNITY_2019_3_OR_NEWER", "UNITY_2019_4_OR_NEWER", "ENABLE_LEGACY_INPUT_MANAGER"));
    private static readonly Lazy<string[]> Newest = new(() =>
        Members("UNITY_EDITOR", "UNITY_2019_3_OR_NEWER", "UNITY_2019_4_OR_NEWER", "UNITY_2022_2_OR_NEWER", "UNITY_6000_0_OR_NEWER", "ENABLE_INPUT_SYSTEM"));

    [Test]
    public void Page_lists_every_member_that_is_touched_and_no_other()
    {
        SortedSet<string> touched = new(Oldest.Value.Concat(Newest.Value), StringComparer.Ordinal);
        if (Environment.GetEnvironmentVariable("MYRIGIDBODY_WRITE") == "1")
        {
            Write(touched, InChinese, EngineMemberPage.Chinese);
            Write(touched, Page, EngineMemberPage.English);
        }

        Assert.That(Rows(Page).Keys, Is.EquivalentTo(touched));
        Assert.That(Rows(InChinese), Is.EqualTo(Rows(Page)));
        Assert.That(Rows(Page).Where(row => row.Value.Since == Unknown).Select(row => row.Key), Is.Empty);
    }

    // nothing that every version has takes their place; a pragma says so where each is used
    private static readonly string[] ObsoleteAndUsed = ["UnityEditor.AssetDatabase.ExportPackage", "UnityEditor.Compilation.AssemblyBuilder"];

    [Test]
    public void What_2019_has_not_is_touched_behind_a_symbol_alone()
    {
        Dictionary<string, (string Since, string Obsolete)> rows = Rows(Page);
        Assert.That(Oldest.Value.Where(member => rows[member].Since != "2019.4"), Is.Empty);
        Assert.That(Newest.Value.Where(member => rows[member].Obsolete.Length > 0), Is.EquivalentTo(ObsoleteAndUsed));
    }

    private static string[] Members(params string[] symbols) =>
        [.. new UnityCompiler([.. Checkout.Gather(Root.Path), .. Checkout.GatherStarter(Root.Path)], symbols).EngineMembers().Distinct()];

    private static Dictionary<string, (string Since, string Obsolete)> Rows(string page) => File.Exists(Root.File(page))
        ? Row().Matches(File.ReadAllText(Root.File(page))).ToDictionary(row => row.Groups[1].Value, row => (row.Groups[2].Value.Trim(), row.Groups[3].Value.Trim()))
        : [];

    private static void Write(SortedSet<string> touched, string page, string head)
    {
        Dictionary<string, (string Since, string Obsolete)> known = Rows(Page);
        File.WriteAllText(Root.File(page), head + string.Concat(touched.Select(member =>
        {
            (string since, string obsolete) = known.GetValueOrDefault(member, (Unknown, ""));
            return $"| `{member}` | {since} | {obsolete} |\n";
        })));
    }

    [GeneratedRegex(@"^\| `([\w.]+)` \| ([^|]*)\| ([^|]*)\|$", RegexOptions.Multiline)]
    private static partial Regex Row();
}
