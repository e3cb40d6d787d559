using System.Diagnostics;
using System.Globalization;
using System.IO.Compression;
using System.Text;
using NUnit.Framework;
using RigidBodyDynamics.Lab.Output;
using RigidBodyDynamics.Lab.Package;
using RigidBodyDynamics.Tests.CommandLine;

namespace RigidBodyDynamics.Tests.Package;

/// <summary>Packages and checkouts made to do harm.</summary>
public sealed class HostilePackageTests
{
    private const int Block = 512;
    private static readonly string Guid = "0123456789abcdef0123456789abcdef";

    [TestCase("99999999999999999999999", "a header names a size")]
    [TestCase("9223372036854775807", "a header names a size")]
    [TestCase("10000000000", "a header names a size")]
    [TestCase("-5", "negative")]
    [TestCase("1e5", "format")]
    public void A_size_that_cannot_be_is_refused_in_one_line(string size, string says) =>
        Assert.That(Refused([.. Pax("size", size), .. Asset("Assets/a.txt")]), Does.Contain(says));

    [TestCase('L')]
    [TestCase('K')]
    [TestCase('x')]
    public void A_name_of_a_gigabyte_takes_a_quarter_of_it_at_most(char type)
    {
        using TemporaryFolder folder = new();
        using (GZipStream zip = new(File.Create(folder.File("a.unitypackage")), CompressionLevel.Fastest))
        {
            zip.Write(Header("././@LongLink", 1L << 30, type));
            byte[] letters = new byte[1 << 20];
            letters.AsSpan().Fill((byte)'a');
            for (int i = 0; i < 1 << 10; i++)
                zip.Write(letters);
        }

        // aborted with 1.1 GB without the limit; measured 790 MB with it
        LabProcess lab = LabProcess.Run(folder.Path, new() { ["DOTNET_GCHeapHardLimit"] = "60000000" }, ["pack", "--list", "a.unitypackage"]);

        Assert.That((lab.ExitCode, lab.Error), Is.EqualTo((2, "error: a.unitypackage: is no Unity package: it unpacks to more than 268435456 bytes" + Environment.NewLine)));
    }

    [Test]
    public void A_second_line_of_a_path_is_not_read() =>
        Assert.That(Read([.. Asset("Assets/a.txt\n00"), .. End])[0].Path, Is.EqualTo("Assets/a.txt"));

    [TestCase('1')]
    [TestCase('2')]
    [TestCase('6')]
    [TestCase('3')]
    public void Links_pipes_and_devices_are_no_assets(char type) =>
        Assert.That(Refused([.. Header(Guid + "/asset", 0, type), .. Asset("Assets/a.txt")]), Does.Contain("is no file but a"));

    [TestCase("Assets/\u001b[31ma\u202e.txt", "has invisible characters")]
    [TestCase("Assets/../../x", "leads out of its folder")]
    [TestCase("Assets\\..\\x", "is outside of Assets and Packages")]
    [TestCase("Assets/a\\..\\..\\..\\x", "leads out of its folder")]
    [TestCase("/etc/passwd", "is outside of Assets and Packages")]
    [TestCase("C:\\x", "is outside of Assets and Packages")]
    [TestCase("Assets/a.txt:stream", "names a drive or a stream")]
    [TestCase("Assets/nul.txt", "has a name that Windows keeps for a device")]
    public void A_list_shows_every_path_and_says_which_not_to_import(string path, string why)
    {
        using TemporaryFolder folder = new();
        File.WriteAllBytes(folder.File("a.unitypackage"), Zipped([.. Asset(path), .. Asset("Assets/b.txt", "f" + Guid[1..]), .. End]));

        LabProcess lab = LabProcess.Run(folder.Path, "pack", "--list", "a.unitypackage");

        Assert.That(lab.ExitCode, Is.EqualTo(1));
        Assert.That(lab.Output, Does.Contain("Assets/b.txt").And.Contain(Lab.Output.Visible.Line(path)).And.Contain("2 files in 0 folders"));
        Assert.That(lab.Output.Any(letter => char.IsControl(letter) && letter != '\n'), Is.False);
        Assert.That(lab.Error.TrimEnd(), Does.StartWith("error: a.unitypackage: do not import it: \"").And.EndsWith(why).And.Not.Contain("\n"));
    }

    [TestCase("con", false)]
    [TestCase("Con.cs", false)]
    [TestCase("nul.tar.gz", false)]
    [TestCase("COM1.txt", false)]
    [TestCase("lpt9", false)]
    [TestCase("aux .cs", false)]
    [TestCase("Console.cs", true)]
    [TestCase("com.unity.cs", true)]
    [TestCase("Auxiliary.cs", true)]
    [TestCase("COM10.txt", true)]
    public void Names_that_Windows_keeps_are_not_packed(string name, bool isPacked)
    {
        Asset folder = new("Assets/MyRigidbody", "0123456789abcdef0123456789abcd00", null, Meta.Folder("0123456789abcdef0123456789abcd00"));
        Asset file = new("Assets/MyRigidbody/" + name, Guid, [1], Meta.Text(Guid));

        Assert.That(() => AssetRules.Checked([folder, file]), isPacked ? Throws.Nothing : Throws.TypeOf<InputException>().With.Message.EndsWith("has a name that Windows keeps for a device"));
    }

    [TestCase("link")]
    [TestCase("folder")]
    [TestCase("loop")]
    [TestCase("pipe")]
    [Platform(Exclude = "Win")]
    public void Links_and_pipes_of_a_checkout_are_not_packed(string kind)
    {
        using TemporaryFolder folder = new();
        string project = Path.Combine(folder.Path, "UnityProject", "Assets", "MyRigidbody"), path = Path.Combine(project, kind);
        Directory.CreateDirectory(project);
        File.WriteAllBytes(project + ".meta", Meta.Folder(Guid));
        File.WriteAllBytes(path + ".meta", Meta.Text("f" + Guid[1..]));
        if (kind == "pipe")
        {
            using Process make = Process.Start("mkfifo", [path]);
            make.WaitForExit();
        }
        else
        {
            File.CreateSymbolicLink(path, kind switch { "link" => "/etc/hostname", "folder" => "/etc", _ => project });
        }

        Assert.That(() => Checkout.Gather(folder.Path), Throws.TypeOf<InputException>().With.Message.EqualTo($"UnityProject/Assets/MyRigidbody/{kind}: is no file of its own but a link, a pipe or a device"));
    }

    private static byte[] End => new byte[2 * Block];

    private static IReadOnlyList<Asset> Read(byte[] tar)
    {
        using TemporaryFolder folder = new();
        File.WriteAllBytes(folder.File("a.unitypackage"), Zipped(tar));
        return PackageReader.Read(folder.File("a.unitypackage"));
    }

    private static string Refused(byte[] tar)
    {
        string message = Assert.Throws<InputException>(() => Read([.. tar, .. End]))!.Message;
        Assert.That(message, Does.Not.Contain("\n"));
        return message;
    }

    private static byte[] Asset(string path, string? guid = null) =>
        [.. Entry((guid ?? Guid) + "/asset", "abc"), .. Entry((guid ?? Guid) + "/asset.meta", "abc"), .. Entry((guid ?? Guid) + "/pathname", path)];

    private static byte[] Pax(string key, string value)
    {
        string record = $" {key}={value}\n";
        int length = record.Length + 1;
        while (length != record.Length + length.ToString(CultureInfo.InvariantCulture).Length)
            length = record.Length + length.ToString(CultureInfo.InvariantCulture).Length;

        return Entry("PaxHeader", length.ToString(CultureInfo.InvariantCulture) + record, 'x');
    }

    private static byte[] Entry(string name, string text, char type = '0')
    {
        byte[] content = Encoding.UTF8.GetBytes(text), padded = new byte[(content.Length + Block - 1) / Block * Block];
        content.CopyTo(padded, 0);
        return [.. Header(name, content.Length, type), .. padded];
    }

    private static byte[] Header(string name, long size, char type)
    {
        byte[] header = new byte[Block];
        Put(0, name);
        Put(100, "0000644\0" + "0000000\0" + "0000000\0" + Convert.ToString(size, 8).PadLeft(11, '0') + "\0" + "00000000000\0" + "        " + type);
        Put(257, type is 'L' or 'K' ? "ustar  \0" : "ustar\000");
        Put(148, Convert.ToString(header.Sum(value => (int)value), 8).PadLeft(6, '0') + "\0 ");
        return header;

        void Put(int at, string text) => Encoding.ASCII.GetBytes(text).CopyTo(header, at);
    }

    private static byte[] Zipped(byte[] tar)
    {
        MemoryStream packed = new();
        using (GZipStream zip = new(packed, CompressionLevel.Fastest))
            zip.Write(tar);

        return packed.ToArray();
    }
}
