using System.IO.Compression;
using System.Security.Cryptography;
using System.Text.RegularExpressions;
using NUnit.Framework;

namespace RigidBodyDynamics.BrowserTests;

/// <summary>The lab in a browser, as files for any web server.</summary>
public sealed partial class SiteFilesTests
{
    [Test]
    public void First_picture_takes_less_than_6_MB_over_the_wire()
    {
        IEnumerable<string> needed = SiteFiles.Names.Where(name => !name.StartsWith("write/", StringComparison.Ordinal) && name is not ("licences.txt" or "service-worker.js" or "plotly.min.js"));
        long bytes = needed.Sum(name => new FileInfo(SiteFiles.InFolder(name + (File.Exists(SiteFiles.InFolder(name + ".gz")) ? ".gz" : string.Empty))).Length);

        Assert.That(bytes, Is.LessThan(6_000_000)); // measured 2.49 million, the editor among them
    }

    [Test]
    public void Page_names_no_address_but_its_own_folder()
    {
        string page = File.ReadAllText(SiteFiles.InFolder("index.html"));

        Assert.That(Links().Matches(page).Select(link => link.Groups[1].Value), Is.Not.Empty.And.All.Matches<string>(link => !link.StartsWith('/') && !link.Contains("//")));
    }

    [Test]
    public void Nothing_of_ours_names_another_server()
    {
        foreach (string name in SiteFiles.Names.Where(name => !name.Contains('/') && name is not ("licences.txt" or "plotly.min.js") && !name.EndsWith(Always, StringComparison.Ordinal)))
        {
            // names of XML's vocabularies are no addresses
            Assert.That(Addresses().Matches(File.ReadAllText(SiteFiles.InFolder(name))).Select(found => found.Value).Where(found => !found.StartsWith("http://www.w3.org/", StringComparison.Ordinal)), Is.Empty, name);
        }
    }

    [Test]
    public void Service_worker_has_every_file_by_its_hash_and_no_other()
    {
        Dictionary<string, string> files = SiteFiles.OfTheWorker();

        Assert.That(files.Keys.Select(name => name == "./" ? "index.html" : name), Is.EquivalentTo(SiteFiles.Names.Where(name => name != "service-worker.js")));
        Assert.That(files.Where(file => file.Value != "sha256-" + Convert.ToBase64String(SHA256.HashData(File.ReadAllBytes(SiteFiles.InFolder(file.Key == "./" ? "index.html" : file.Key))))), Is.Empty);
    }

    [Test]
    public void What_lies_packed_beside_a_file_is_that_file()
    {
        string[] names = [.. SiteFiles.Names.Where(name => !name.EndsWith(Always, StringComparison.Ordinal))];

        Assert.That(names, Is.Not.Empty);
        foreach (string name in names)
        {
            byte[] plain = File.ReadAllBytes(SiteFiles.InFolder(name));
            Assert.That(Unpacked(name + ".br", packed => new BrotliStream(packed, CompressionMode.Decompress)), Is.EqualTo(plain), name);
            Assert.That(Unpacked(name + ".gz", packed => new GZipStream(packed, CompressionMode.Decompress)), Is.EqualTo(plain), name);
        }
    }

    [Test]
    public void Assemblies_and_WebAssembly_lie_packed_under_a_name_that_no_server_refuses()
    {
        string[] framework = [.. SiteFiles.Names.Where(name => name.Contains("/_framework/"))];

        Assert.That(framework.Select(Path.GetExtension).Distinct(), Is.EquivalentTo(new[] { ".js", Always }));
        foreach (string name in framework.Where(name => name.EndsWith(Always, StringComparison.Ordinal)))
        {
            byte[] start = Unpacked(name, packed => new GZipStream(packed, CompressionMode.Decompress))[..4];
            // an assembly as Windows names it, or a module of WebAssembly
            Assert.That(start[0] == 'M' && start[1] == 'Z' || start is [0, (byte)'a', (byte)'s', (byte)'m'], Is.True, name);
        }
    }

    [Test]
    public void Licences_name_what_is_shipped_and_whose_it_is()
    {
        string licences = File.ReadAllText(SiteFiles.InFolder("licences.txt"));

        foreach (string text in new[] { "Microsoft.NETCore.App.Runtime.Mono.browser-wasm", "Microsoft.CodeAnalysis.CSharp", "The MyRigidbody authors", "Permission is hereby granted" })
            Assert.That(licences, Does.Contain(text));
    }

    private const string Always = ".bin";

    private static byte[] Unpacked(string name, Func<Stream, Stream> unpack)
    {
        using Stream packed = unpack(File.OpenRead(SiteFiles.InFolder(name)));
        using MemoryStream plain = new();
        packed.CopyTo(plain);
        return plain.ToArray();
    }

    [GeneratedRegex("(?:src|href)=\"(?!#|data:)([^\"]*)\"")]
    private static partial Regex Links();

    [GeneratedRegex("(?:https?|wss?)://[a-z][^\\s\"'`)]*")]
    private static partial Regex Addresses();
}
