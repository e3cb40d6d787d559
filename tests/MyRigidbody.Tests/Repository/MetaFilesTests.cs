using NUnit.Framework;
using RigidBodyDynamics.UnityFiles.Checks;

namespace RigidBodyDynamics.Tests.Repository;

/// <summary>Unity knows the files of the package and of the project by the GUIDs in their metas.</summary>
public sealed class MetaFilesTests
{
    private static readonly ProjectFiles Files = ProjectFiles.Read(Root.Path);

    // missing, orphan or not as 2019.4 writes it; a GUID that is used twice, not lower-case or made up
    [TestCase(ProjectFiles.Package, 100)]
    [TestCase(ProjectFiles.Judge, 30)]
    [TestCase(ProjectFiles.Assets, 30)]
    public void Every_file_and_folder_has_a_meta_as_Unity_2019_writes_it(string folder, int atLeast)
    {
        Assert.That(Files.ImportedFrom(folder).Count, Is.AtLeast(atLeast));
        Assert.That(Metas.Findings(Files, folder), Is.Empty, $"bash .ci/metas {folder} writes those that are missing");
    }

    [Test]
    public void No_GUID_of_the_package_is_one_of_the_project() =>
        Assert.That(Metas.Findings(Files, ProjectFiles.Package, ProjectFiles.Judge, ProjectFiles.Assets), Is.Empty);
}
