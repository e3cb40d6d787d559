using NUnit.Framework;
using RigidBodyDynamics.UnityFiles.Checks;

namespace RigidBodyDynamics.Tests.UnityProject;

/// <summary>An editor would report no error in the Unity project, as far as that can be tested without one.</summary>
public sealed class ProjectTests
{
    [Test]
    public void Checker_finds_nothing() => Assert.That(ProjectChecker.Findings(Change.Real), Is.Empty);

    [Test]
    public void What_an_editor_adds_when_it_opens_the_project_is_no_finding() => Assert.That(
        ProjectChecker.Findings(Change.Real
            .With(Change.Settings + "AudioManager.asset", "%YAML 1.1\n%TAG !u! tag:unity3d.com,2011:\n--- !u!11 &1\nAudioManager:\n  m_Volume: 1\n")
            .With("UnityProject/Packages/packages-lock.json", "{}")),
        Is.Empty);

    // only the editor would find each of these, or nothing would
    [TestCaseSource(typeof(BrokenScenes), nameof(BrokenScenes.All))]
    [TestCaseSource(typeof(BrokenComponents), nameof(BrokenComponents.All))]
    [TestCaseSource(typeof(BrokenFiles), nameof(BrokenFiles.All))]
    [TestCaseSource(typeof(BrokenShaders), nameof(BrokenShaders.All))]
    public void Checker_finds(ProjectFiles wrong, string words) => Assert.That(ProjectChecker.Findings(wrong), Has.Some.Contains(words));
}
