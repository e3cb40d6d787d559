using System.Runtime.InteropServices.JavaScript;
using System.Security.Cryptography;
using System.Text;
using RigidBodyDynamics.Judging;
using RigidBodyDynamics.Lab.Grading.Reading;
using RigidBodyDynamics.Lab.Grading.Students;
using RigidBodyDynamics.Lab.Languages;
using RigidBodyDynamics.Lab.Output;
using RigidBodyDynamics.Lab.Package;
using RigidBodyDynamics.StudentScripts;

namespace RigidBodyDynamics.Web.Write;

/// <summary>Packages dropped onto the page, and the package for submission.</summary>
internal static partial class Packages
{
    private const string Folder = "Assets/MyRigidbodyStarter", FolderMeta = "MyRigidbodyStarter.meta", Main = "MyRigidbody.cs", MainMeta = Main + ".meta";

    private static string? _whyNot;

    /// <summary>The scripts in a file, read as by grade: their names and texts, or the error.</summary>
    [JSExport]
    internal static string Unpack(string name, byte[] bytes)
    {
        IReadOnlyList<Piece> pieces = Reader.Read(new Spot(name, [name]), bytes);
        Script[] scripts = [.. pieces.SelectMany(piece => piece.Scripts)];
        Finding? problem = scripts.Length > 0 ? null : pieces.Select(piece => piece.Problem).FirstOrDefault(found => found != null) ?? Problems.NoScript();
        return problem == null
            ? Json.Of(new { files = scripts.Select(script => new { name = InPackage(script.Spot.Shown), text = SourceText.Decode(script.Bytes).Text }) })
            : Refusal(problem.Code, problem.English, problem.Chinese);
    }

    /// <summary>The .unitypackage of a submission with this name; empty where it is refused.</summary>
    [JSExport]
    internal static byte[] Package(string[] names, int[] lengths, byte[] bytes, string name)
    {
        Student? student = StudentName.Read(name).FirstOrDefault();
        if (!StudentName.IsAsAsked(name) || student == null || $"{student.Id}_{student.Name}" != StudentName.Stem(name))
        {
            _whyNot = Refusal(
                "not-named-as-asked",
                $"\"{name}\" is not read as student number and name: six to sixteen digits, an underscore, the name.",
                $"“{name}”不能识别为“学号_姓名”：应为 6 至 16 位学号、下划线和姓名。");
            return [];
        }

        try
        {
            Asset[] assets = [Starter(Folder, null, FolderMeta), .. Json.Files(names, lengths, bytes).Select(InProject)];
            return PackageWriter.Write(AssetRules.Checked([.. assets.OrderBy(asset => asset.Guid, StringComparer.Ordinal)]));
        }
        catch (InputException refused)
        {
            _whyNot = Refusal("not-packed", refused.Message, $"无法打包：{Sentences.InChinese(refused.Message)}");
            return [];
        }
    }

    /// <summary>Why the last package was refused.</summary>
    [JSExport]
    internal static string? WhyNot() => _whyNot;

    private static Asset InProject(ScriptFile file)
    {
        // as the requirements of a package have it: no byte order mark, and LF line ends
        byte[] text = Encoding.UTF8.GetBytes(SourceText.Decode(file.Bytes).Text.ReplaceLineEndings("\n"));
        string name = file.Name.Split('/', '\\')[^1], path = Folder + "/" + name;
        if (name == Main)
            return Starter(path, text, MainMeta);

        // the same in every package, so that Unity recognises the same file
        string guid = Convert.ToHexStringLower(SHA256.HashData(Encoding.UTF8.GetBytes(path)))[..32], meta = Encoding.UTF8.GetString(Resource(MainMeta));
        return new Asset(path, guid, text, Encoding.UTF8.GetBytes(meta.Replace(Meta.GuidOf(MainMeta, Resource(MainMeta)), guid, StringComparison.Ordinal)));
    }

    // with the starter's own GUID it replaces the given file
    private static Asset Starter(string path, byte[]? content, string meta) => new(path, Meta.GuidOf(meta, Resource(meta)), content, Resource(meta));

    private static byte[] Resource(string name)
    {
        using Stream resource = typeof(Packages).Assembly.GetManifestResourceStream(name)!;
        using MemoryStream bytes = new();
        resource.CopyTo(bytes);
        return bytes.ToArray();
    }

    private static string InPackage(string shown) => shown[(shown.LastIndexOf('!') + 1)..];

    private static string Refusal(string code, string english, string chinese) => Json.Of(new { finding = new { code, en = english, zh = chinese } });
}
