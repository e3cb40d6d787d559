using System.IO.Compression;
using System.Text;
using NUnit.Framework;
using RigidBodyDynamics.Lab.Output;
using RigidBodyDynamics.Lab.Package;
using RigidBodyDynamics.Tests.CommandLine;
using RigidBodyDynamics.Tests.Repository;

namespace RigidBodyDynamics.Tests.Package;

/// <summary>The package byte by byte, as Unity's own editor writes it.</summary>
public sealed class PackageFormatTests
{
    private const int Block = 512;

    private static readonly IReadOnlyList<Asset> Assets = Checkout.Gather(Root.Path);
    private static readonly byte[] Packed = PackageWriter.Write(Assets);
    private static readonly byte[] Tar = Unzip(Packed);

    [Test]
    public void Gzip_header_has_no_name_no_time_and_no_system() =>
        // magic, deflate, no flags, time 0, best compression, system 0: Unity on Windows trips over other names
        Assert.That(Packed[..10], Is.EqualTo(new byte[] { 0x1f, 0x8b, 8, 0, 0, 0, 0, 0, 2, 0 }));

    [Test]
    public void Every_header_is_plain_ustar_of_nobody_at_no_time()
    {
        foreach ((string name, byte[] header, byte[] _) in Entries())
        {
            Assert.That(Encoding.ASCII.GetString(header, 257, 8), Is.EqualTo("ustar\000"), name);
            Assert.That((char)header[156], Is.EqualTo(name.EndsWith('/') ? '5' : '0'), name);
            Assert.That((Octal(header, 108, 8), Octal(header, 116, 8), Octal(header, 136, 12)), Is.EqualTo((0L, 0L, 0L)), name);
            Assert.That(header[265..329], Is.All.Zero, name + ": names of user and group");
            Assert.That(header[345..500], Is.All.Zero, name + ": prefix");
            Assert.That(Octal(header, 148, 8), Is.EqualTo(Sum(header)), name + ": checksum");
        }
    }

    [Test]
    public void Folders_stand_in_the_order_of_their_GUIDs_each_with_asset_meta_and_path_in_that_order()
    {
        string[] expected = [.. Assets.SelectMany(asset => new[] { "/", asset.IsFolder ? "" : "/asset", "/asset.meta", "/pathname" }
            .Where(part => part.Length > 0).Select(part => asset.Guid + part))];

        Assert.That(Entries().Select(entry => entry.Name), Is.EqualTo(expected));
        Assert.That(Assets.Select(asset => asset.Guid), Is.Ordered.Using<string>(string.CompareOrdinal));
    }

    [Test]
    public void Archive_ends_with_two_blocks_of_zeros_and_no_more()
    {
        (string _, byte[] _, byte[] last) = Entries().Last();
        int used = Entries().Sum(entry => Block + (entry.Content.Length + Block - 1) / Block * Block);

        Assert.That(last, Is.Not.Empty);
        Assert.That(Tar, Has.Length.EqualTo(used + 2 * Block));
        Assert.That(Tar[used..], Is.All.Zero);
    }

    [Test]
    public void Path_is_the_path_and_nothing_else()
    {
        foreach ((string name, byte[] _, byte[] content) in Entries().Where(entry => entry.Name.EndsWith("/pathname", StringComparison.Ordinal)))
            Assert.That(Encoding.UTF8.GetString(content), Does.Match(@"\AAssets/MyRigidbody(/[A-Za-z0-9_.-]+)*\z"), name);
    }

    [Test]
    public void Reader_gives_back_what_was_packed()
    {
        using TemporaryFolder folder = new();
        File.WriteAllBytes(folder.File("a.unitypackage"), Packed);

        IReadOnlyList<Asset> read = PackageReader.Read(folder.File("a.unitypackage"));

        Assert.That(read.Select(asset => (asset.Path, asset.Guid)), Is.EqualTo(Assets.Select(asset => (asset.Path, asset.Guid))));
        Assert.That(read.Select(asset => asset.Content), Is.EqualTo(Assets.Select(asset => asset.Content)));
        Assert.That(read.Select(asset => asset.Meta), Is.EqualTo(Assets.Select(asset => asset.Meta)));
    }

    [Test]
    public void Truncated_and_damaged_packages_are_refused_in_one_line_or_read([Range(0, 199)] int seed)
    {
        Random random = new(seed);
        byte[] damaged = seed % 2 == 0 ? Packed[..random.Next(Packed.Length)] : [.. Packed];
        for (int flip = 0; flip < 1 + seed % 5 && damaged.Length > 0; flip++)
            damaged[random.Next(damaged.Length)] ^= (byte)(1 << random.Next(8));

        using TemporaryFolder folder = new();
        File.WriteAllBytes(folder.File("a.unitypackage"), damaged);
        try
        {
            PackageReader.Read(folder.File("a.unitypackage"));
        }
        catch (InputException refused)
        {
            Assert.That(refused.Message, Does.Not.Contain("\n").And.Contain("a.unitypackage"));
        }
    }

    private static IEnumerable<(string Name, byte[] Header, byte[] Content)> Entries()
    {
        for (int at = 0; Tar[at] != 0;)
        {
            byte[] header = Tar[at..(at + Block)];
            int length = (int)Octal(header, 124, 12);
            at += Block;
            yield return (Encoding.ASCII.GetString(header, 0, 100).TrimEnd('\0'), header, Tar[at..(at + length)]);
            at += (length + Block - 1) / Block * Block;
        }
    }

    private static long Octal(byte[] header, int from, int length) =>
        Convert.ToInt64(Encoding.ASCII.GetString(header, from, length).Trim('\0', ' '), 8);

    // all bytes, those of the checksum itself as spaces
    private static long Sum(byte[] header) => header.Select((value, i) => i is >= 148 and < 156 ? 32L : value).Sum();

    private static byte[] Unzip(byte[] packed)
    {
        MemoryStream all = new();
        using GZipStream zip = new(new MemoryStream(packed), CompressionMode.Decompress);
        zip.CopyTo(all);
        return all.ToArray();
    }
}
