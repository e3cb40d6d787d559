using System.Text.RegularExpressions;
using RigidBodyDynamics.Lab.Languages;

namespace RigidBodyDynamics.Tests.Repository;

/// <summary>A text in English and the same in Chinese, and the file that has both.</summary>
internal sealed record Translated(string File, string English, string Chinese);

/// <summary>The page of terms, and all texts of ours that stand in two languages side by side.</summary>
internal static partial class Glossary
{
    private static readonly string[] Sources = ["MyRigidbody.Judge", "MyRigidbody.Lab", "MyRigidbody.Scripts", "UnityProject/Assets"];

    /// <summary>The rows of those tables that have so many columns, without their heads.</summary>
    public static IEnumerable<string[]> Rows(int columns) => Tree.Text("docs/terms.md").Split('\n')
        .Where(line => line.StartsWith("| ", StringComparison.Ordinal) && !line.StartsWith("| ---", StringComparison.Ordinal))
        .Select(line => line.Trim()[1..^1].Split('|', StringSplitOptions.TrimEntries))
        .Where(row => row.Length == columns && row[1] is not ("中文" or "but"));

    /// <summary>Of C#, two literals one after the other, the second in Chinese; of the browser's page, what stands as en and zh; and what the command line prints.</summary>
    public static Translated[] Texts()
    {
        IEnumerable<Translated> inCode = Sources.SelectMany(folder => Tree.Files(folder, "*.cs"))
            .SelectMany(file => Literals().Matches(Tree.Text(file)).Select(match => new Translated(file, match.Groups[1].Value, match.Groups[2].Value)));
        IEnumerable<Translated> onPage = Tree.Files("MyRigidbody.Web/Page", "*words.js")
            .SelectMany(file => Entry().Matches(Tree.Text(file)).Select(match => new Translated(file, match.Groups[1].Value, match.Groups[2].Value)));
        IEnumerable<Translated> printed = Sentences.Read().Select(pair => new Translated("MyRigidbody.Lab/Languages", pair.English, pair.Chinese));
        return [.. inCode.Where(text => Chinese().IsMatch(text.Chinese) && !Chinese().IsMatch(text.English)), .. onPage, .. printed];
    }

    [GeneratedRegex(@"""((?:[^""\\]|\\.)*)""\s*,\s*[$@]*""((?:[^""\\]|\\.)*)""")]
    private static partial Regex Literals();

    [GeneratedRegex(@"en: '((?:[^'\\]|\\.)*)',\s*zh: '((?:[^'\\]|\\.)*)'")]
    private static partial Regex Entry();

    [GeneratedRegex(@"\p{IsCJKUnifiedIdeographs}")]
    private static partial Regex Chinese();
}
