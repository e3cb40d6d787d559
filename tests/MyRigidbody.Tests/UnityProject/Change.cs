using NUnit.Framework;
using RigidBodyDynamics.Tests.Repository;
using RigidBodyDynamics.UnityFiles.Checks;

namespace RigidBodyDynamics.Tests.UnityProject;

/// <summary>The Unity project, and copies of it in memory in which something is wrong.</summary>
internal static class Change
{
    public const string Assets = "UnityProject/Assets/MyRigidbody/", LabScene = Assets + "Scenes/Lab.unity", SlabScene = Assets + "Scenes/TumblingSlab.unity";
    public const string Settings = "UnityProject/ProjectSettings/", Sources = Assets + "Scripts/";

    public static ProjectFiles Real { get; } = ProjectFiles.Read(Root.Path);

    /// <summary>The text of one of its files.</summary>
    public static string Text(string path) => Real.Texts[path];

    public static string Guid(string asset) => Text(asset + ".meta").Split('\n')[1]["guid: ".Length..];

    /// <summary>A copy with another text in the place of the first one like it.</summary>
    public static ProjectFiles Replace(string path, string old, string other)
    {
        int at = Text(path).IndexOf(old, StringComparison.Ordinal);
        return at >= 0 ? Real.With(path, Text(path)[..at] + other + Text(path)[(at + old.Length)..]) : throw new ArgumentException($"{path} has no {old}", nameof(old));
    }

    /// <summary>A test that the checker reports this copy, by a finding with some words in it.</summary>
    public static TestCaseData Found(string what, ProjectFiles wrong, string words) =>
        new TestCaseData(wrong, words).SetName(what.Replace(' ', '_'));
}
