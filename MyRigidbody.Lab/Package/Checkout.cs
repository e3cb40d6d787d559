using RigidBodyDynamics.Lab.Output;

namespace RigidBodyDynamics.Lab.Package;

/// <summary>The files of the packages, from a checkout of the repository.</summary>
internal static class Checkout
{
    private const string Top = "Assets/MyRigidbody", Project = "UnityProject/" + Top, Core = "MyRigidbody.Core";
    private const string StarterTop = "Assets/MyRigidbodyStarter", StarterProject = "UnityProject/" + StarterTop, Judge = "MyRigidbody.Judge";

    // GUIDs of assets that are elsewhere in the repository, or have no meta because they are the root of a package
    private const string CoreFolderGuid = "5a72f811ae3ef5e9cc67bc435aecb9c7", LicenseGuid = "9ba1d9b5a12c61ff5f8a201a59ec8309";
    private const string JudgeFolderGuid = "953c8eab552180b16740ee8aeca94e2d", StarterLicenseGuid = "f0d9fe55bc6b5cfac000d30443332e3c";

    /// <summary>The root of the checkout: the folder with the solution, here, above, or above the program.</summary>
    public static string Root() => Find() ?? throw new InputException("pack: needs a checkout of the repository; there is no MyRigidbody.sln here or above");

    /// <summary>The same, or null if there is none.</summary>
    public static string? Find() => Above(Directory.GetCurrentDirectory()) ?? Above(AppContext.BaseDirectory);

    /// <summary>The assets of the whole package, in the order of their GUIDs.</summary>
    public static IReadOnlyList<Asset> Gather(string root)
    {
        List<Asset> assets = [Read(root, Project, Top)];
        Walk(root, Project, Top, path => path == Project + "/Tests", assets);
        // Batch compiles to nothing in Unity
        Walk(root, Core, Top + "/Core", path => path == Core + "/Batch" || IsNothingToUnity(path), assets);
        assets.Add(new Asset(Top + "/Core", CoreFolderGuid, null, Meta.Folder(CoreFolderGuid)));
        assets.Add(new Asset(Top + "/LICENSE.txt", LicenseGuid, Bytes(root, "LICENSE"), Meta.Text(LicenseGuid)));
        return AssetRules.Checked([.. assets.OrderBy(asset => asset.Guid, StringComparer.Ordinal)]);
    }

    /// <summary>The assets of the students' package, in the order of their GUIDs: the script to start from, and what checks it.</summary>
    public static IReadOnlyList<Asset> GatherStarter(string root)
    {
        const string Into = StarterTop + "/Editor/Judge";
        List<Asset> assets = [Read(root, StarterProject, StarterTop)];
        Walk(root, StarterProject, StarterTop, path => false, assets);
        Walk(root, Judge, Into, IsNothingToUnity, assets);
        assets.Add(new Asset(Into, JudgeFolderGuid, null, Meta.Folder(JudgeFolderGuid)));
        assets.Add(new Asset(StarterTop + "/LICENSE.txt", StarterLicenseGuid, Bytes(root, "LICENSE"), Meta.Text(StarterLicenseGuid)));
        return AssetRules.Checked([.. assets.OrderBy(asset => asset.Guid, StringComparer.Ordinal)]);
    }

    // a C# project and a UPM package have no meaning in a project with the sources
    private static bool IsNothingToUnity(string path) =>
        Path.GetFileName(path) is "package.json" or "packages.lock.json" || path.EndsWith(".csproj", StringComparison.Ordinal);

    private static void Walk(string root, string folder, string into, Predicate<string> isLeftOut, List<Asset> assets)
    {
        string full = Path.Combine(root, folder);
        if (!Directory.Exists(full))
            throw new InputException($"{folder}: is missing in the checkout {root}");

        foreach (string entry in Directory.EnumerateFileSystemEntries(full).Order(StringComparer.Ordinal))
        {
            string name = Path.GetFileName(entry), path = folder + "/" + name;
            if (IsHidden(name) || isLeftOut(path.EndsWith(".meta", StringComparison.Ordinal) ? path[..^".meta".Length] : path))
                continue;

            if (name.EndsWith(".meta", StringComparison.Ordinal))
            {
                if (!Path.Exists(entry[..^".meta".Length]))
                    throw new InputException($"{path}: nothing stands beside it");

                continue;
            }

            assets.Add(Read(root, path, into + "/" + name));
            if (Directory.Exists(entry))
                Walk(root, path, into + "/" + name, isLeftOut, assets);
        }
    }

    private static Asset Read(string root, string path, string into)
    {
        byte[] meta = File.Exists(Path.Combine(root, path + ".meta"))
            ? Bytes(root, path + ".meta")
            : throw new InputException($"{path}: has no meta; bash .ci/metas writes one");
        bool isFolder = Directory.Exists(Path.Combine(root, path)) && new DirectoryInfo(Path.Combine(root, path)).LinkTarget == null;
        return new Asset(into, Meta.GuidOf(path + ".meta", meta), isFolder ? null : Bytes(root, path), meta);
    }

    // hidden files, which Unity does not import either
    private static bool IsHidden(string name) =>
        name.StartsWith('.') || name.EndsWith('~') || name.EndsWith(".tmp", StringComparison.Ordinal) || name.Equals("cvs", StringComparison.OrdinalIgnoreCase);

    private static byte[] Bytes(string root, string path)
    {
        // a link may lead anywhere, and a pipe may not end
        if (Path.Exists(Path.Combine(root, path)) && !RealPath.IsPlainFile(Path.Combine(root, path)))
            throw new InputException($"{path}: is no file of its own but a link, a pipe or a device");

        try
        {
            return File.ReadAllBytes(Path.Combine(root, path));
        }
        catch (Exception refused) when (refused is IOException or UnauthorizedAccessException)
        {
            throw new InputException($"{path}: cannot be read: {refused.Message.ReplaceLineEndings(" ")}");
        }
    }

    private static string? Above(string folder)
    {
        for (DirectoryInfo? here = new(folder); here != null; here = here.Parent)
        {
            if (File.Exists(Path.Combine(here.FullName, "MyRigidbody.sln")))
                return here.FullName;
        }

        return null;
    }
}
