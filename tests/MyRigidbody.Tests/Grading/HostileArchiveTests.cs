using System.Formats.Tar;
using System.IO.Compression;
using NUnit.Framework;
using RigidBodyDynamics.Lab.Grading.Reading;

namespace RigidBodyDynamics.Tests.Grading;

/// <summary>Archives made to do harm, or broken: each is a line to the instructor, and nothing is written or followed.</summary>
public sealed class HostileArchiveTests
{
    private const string Name = "210840007_x.unitypackage";
    private static readonly (string, string) Main = ("Assets/MyRigidbody.cs", Archives.Source);

    [Test]
    public void Script_of_a_tar_that_is_not_compressed_is_read_and_noted()
    {
        Piece read = Archives.Read(Name, Archives.Tar(Main)).Single();

        Assert.That((read.Scripts.Count, read.Problem), Is.EqualTo((1, (object?)null)));
        Assert.That(read.Notes.Select(note => note.Code), Is.EqualTo(new[] { "not-gzipped" }));
    }

    [Test]
    public void Zip_called_a_package_is_one_submission_and_noted()
    {
        byte[] zip = Archives.Zip(("Assets/MyRigidbody.cs", Archives.Bytes(Archives.Source)), ("Assets/Util.cs", Archives.Bytes("class Util { }")));
        Piece read = Archives.Read(Name, zip).Single();

        Assert.That((read.Scripts.Count, read.IsPackage), Is.EqualTo((2, true)));
        Assert.That(read.Notes.Select(note => note.Code), Is.EqualTo(new[] { "wrong-extension" }));
    }

    [Test]
    public void Package_called_a_zip_is_read_and_noted() =>
        Assert.That(Archives.Read("210840007_x.zip", Archives.Package(Main)).Single().Notes.Select(note => note.Code), Is.EqualTo(new[] { "wrong-extension" }));

    [Test]
    public void Unpacked_package_in_a_zip_has_its_paths()
    {
        byte[] zip = Archives.Zip(("a/0123/asset", Archives.Bytes(Archives.Source)), ("a/0123/pathname", Archives.Bytes("Assets/MyRigidbody.cs")));

        Assert.That(Archives.Read("x.zip", zip).SelectMany(piece => piece.Scripts).Single().Spot.Shown, Is.EqualTo("x.zip!Assets/MyRigidbody.cs"));
    }

    [TestCase(3, true)]
    [TestCase(4, false)]
    public void Zips_in_zips_are_read_to_the_third(int depth, bool isRead)
    {
        byte[] bytes = Archives.Package(Main);
        string name = "p.unitypackage";
        for (int i = 1; i <= depth; i++)
            (bytes, name) = (Archives.Zip((name, bytes)), $"z{i}.zip");

        Piece read = Archives.Read(name, bytes).Single();

        Assert.That(read.Scripts.Any(), Is.EqualTo(isRead));
        Assert.That(read.Problem?.Code, Is.EqualTo(isRead ? null : "nested-too-deep"));
    }

    [Test]
    public void Gzip_that_unpacks_to_two_gigabytes_is_refused()
    {
        MemoryStream packed = new();
        using (GZipStream zip = new(packed, CompressionLevel.Optimal, leaveOpen: true))
        using (TarWriter tar = new(zip, TarEntryFormat.Pax, leaveOpen: true))
            tar.WriteEntry(new PaxTarEntry(TarEntryType.RegularFile, "00/asset") { DataStream = new Zeros(2L << 30) });

        Assert.That(packed.Length, Is.LessThan(1 << 22)); // measured 2.1e6
        Assert.That(Archives.Read(Name, packed.ToArray()).Single().Problem?.Code, Is.EqualTo("too-large"));
    }

    [Test]
    public void Zip_whose_entry_unpacks_to_a_gigabyte_is_refused()
    {
        MemoryStream bytes = new();
        using (ZipArchive zip = new(bytes, ZipArchiveMode.Create, leaveOpen: true))
        {
            using Stream entry = zip.CreateEntry("inner.zip").Open();
            new Zeros(1L << 30).CopyTo(entry);
        }

        Assert.That(Archives.Read("a.zip", bytes.ToArray()).Single().Problem?.Code, Is.EqualTo("too-large"));
    }

    [Test]
    public void Size_that_a_zip_gives_is_not_believed()
    {
        // the sizes in the directory say 10; zeros that say so are a script of 4 MB
        byte[] zip = Archives.Zip(("MyRigidbody.cs", new byte[4 << 20]));
        byte[] size = BitConverter.GetBytes(4 << 20), lie = BitConverter.GetBytes(10);
        for (int at = zip.AsSpan().IndexOf(size); at >= 0; at = zip.AsSpan().IndexOf(size))
            lie.CopyTo(zip, at);

        Assert.That(Archives.Read("a.zip", zip).SelectMany(piece => piece.Scripts).Where(script => script.Bytes.Length > Limits.Script), Is.Empty);
    }

    [TestCase(true)]
    [TestCase(false)]
    public void Hundred_thousand_entries_are_refused(bool isZip)
    {
        (string, byte[])[] files = [.. Enumerable.Range(0, 100_000).Select(i => ($"{i}.cs", Array.Empty<byte>()))];
        byte[] bytes = isZip ? Archives.Zip(files) : Archives.Package([.. Enumerable.Range(0, 40_000).Select(i => ($"Assets/{i}.cs", ""))]);

        Assert.That(Archives.Read(isZip ? "a.zip" : Name, bytes).Single().Problem?.Code, Is.EqualTo("too-many-entries"));
    }

    [Test]
    public void More_scripts_than_anybody_writes_are_left_and_noted()
    {
        Piece read = Archives.Read(Name, Archives.Package([.. Enumerable.Range(0, 400).Select(i => ($"Assets/{i}.cs", ""))])).Single();

        Assert.That((read.Scripts.Count, read.Notes.Single().Code), Is.EqualTo((Limits.Scripts, "too-many-scripts")));
    }

    [TestCase("../../../etc/MyRigidbody.cs")]
    [TestCase("/etc/MyRigidbody.cs")]
    [TestCase("C:\\Windows\\MyRigidbody.cs")]
    public void Path_that_leads_out_is_a_name_and_noted(string path)
    {
        Piece package = Archives.Read(Name, Archives.Package((path, Archives.Source))).Single();
        IReadOnlyList<Piece> zip = Archives.Read("a.zip", Archives.Zip((path, Archives.Bytes(Archives.Source))));

        Assert.That(package.Scripts.Single().Spot.Names, Has.None.EqualTo(".."));
        Assert.That(package.Notes.Select(note => note.Code), Is.EqualTo(new[] { "path-outside" }));
        Assert.That(zip.Single().Scripts.Single().Spot.Name, Is.EqualTo("MyRigidbody.cs"));
        Assert.That(zip.Single().Notes.Select(note => note.Code), Is.EqualTo(new[] { "path-outside" }));
    }

    [Test]
    public void Links_in_a_package_are_not_followed()
    {
        MemoryStream bytes = new();
        using (TarWriter tar = new(bytes, TarEntryFormat.Ustar, leaveOpen: true))
        {
            tar.WriteEntry(new UstarTarEntry(TarEntryType.SymbolicLink, "00/asset") { LinkName = "/etc/passwd" });
            Archives.Add(tar, "00/pathname", Archives.Bytes("Assets/MyRigidbody.cs"));
        }

        Piece read = Archives.Read(Name, Archives.Zipped(bytes.ToArray())).Single();

        Assert.That((read.Scripts.Count, read.Notes.Single().Code), Is.EqualTo((0, "link")));
    }

    [Test]
    public void Links_in_a_zip_are_not_followed()
    {
        MemoryStream bytes = new();
        using (ZipArchive zip = new(bytes, ZipArchiveMode.Create, leaveOpen: true))
        {
            ZipArchiveEntry entry = zip.CreateEntry("MyRigidbody.cs");
            entry.ExternalAttributes = unchecked((int)0xa1ff0000);
            using Stream content = entry.Open();
            content.Write("/etc/passwd"u8);
        }

        Piece read = Archives.Read("a.zip", bytes.ToArray()).Single();

        Assert.That((read.Scripts.Count, read.Notes.Single().Code), Is.EqualTo((0, "link")));
    }

    [Test]
    public void Links_in_a_folder_are_not_followed()
    {
        using CommandLine.TemporaryFolder folder = new();
        string secret = folder.File("secret.cs");
        File.WriteAllText(secret, Archives.Source);
        Directory.CreateDirectory(folder.File("class"));
        try
        {
            File.CreateSymbolicLink(folder.File("class/MyRigidbody.cs"), secret);
            Directory.CreateSymbolicLink(folder.File("class/around"), folder.Path);
        }
        catch (IOException)
        {
            return; // Windows asks for a right
        }

        HandedIn read = HandedIn.Read([folder.File("class")], "out");

        Assert.That(read.Pieces, Is.Empty);
        Assert.That(read.Notes.Select(note => note.Finding.Code), Is.EqualTo(new[] { "link", "link" }));
    }

    [Test]
    public void Zip_that_asks_for_a_password_says_so()
    {
        byte[] zip = Archives.Zip(("MyRigidbody.cs", Archives.Bytes(Archives.Source)));
        // the first bit of the flags, in the directory and before the entry
        foreach ((string mark, int flags) in new[] { ("PK\x01\x02", 8), ("PK\x03\x04", 6) })
            zip[zip.AsSpan().IndexOf(Archives.Bytes(mark)) + flags] |= 1;

        Assert.That(Archives.Read("a.zip", zip).Single().Problem?.Code, Is.EqualTo("encrypted"));
    }

    [Test]
    public void Archive_cut_anywhere_says_so()
    {
        foreach ((string name, byte[] whole) in new[] { (Name, Archives.Package(Main)), ("a.zip", Archives.Zip(("MyRigidbody.cs", Archives.Bytes(Archives.Source)))) })
        {
            for (int length = 4; length < whole.Length; length++)
                Assert.That(Said(Archives.Read(name, whole[..length]).Single()), Is.EqualTo("truncated").Or.EqualTo("damaged").Or.EqualTo("checksum"), $"{name} cut at {length} of {whole.Length}");
        }
    }

    [Test]
    public void Package_whose_checksum_or_length_does_not_fit_is_judged_and_noted()
    {
        byte[] package = Archives.Package(Main);
        foreach (int place in new[] { 1, 8 })
        {
            byte[] changed = [.. package];
            changed[^place] ^= 1;
            Piece read = Archives.Read(Name, changed).Single();
            Assert.That((read.Scripts.Count, Said(read)), Is.EqualTo((1, "checksum")));
        }
    }

    [TestCase("x.rar", "Rar!\x1a\a\0", "not-read")]
    [TestCase("x.zip", "", "empty")]
    [TestCase("x.unitypackage", "hello, this is no package", "damaged")]
    [TestCase("x.cs", "PK\x05\x06\0\0\0\0\0\0\0\0\0\0\0\0\0\0\0\0\0\0", "")]
    public void What_is_none_of_these_says_so(string name, string content, string code) =>
        Assert.That(Archives.Read(name, Archives.Bytes(content)).Single().Problem?.Code ?? string.Empty, Is.EqualTo(code));

    private static string Said(Piece read) => read.Problem?.Code ?? string.Join(' ', read.Notes.Select(note => note.Code));

    /// <summary>As many zeros as one likes.</summary>
    private sealed class Zeros(long length) : Stream
    {
        private long _left = length;

        public override bool CanRead => true;

        public override bool CanSeek => true;

        public override bool CanWrite => false;

        public override long Length { get; } = length;

        public override long Position { get => Length - _left; set => _left = Length - value; }

        public override int Read(byte[] buffer, int offset, int count)
        {
            int read = (int)Math.Min(count, _left);
            Array.Clear(buffer, offset, read);
            _left -= read;
            return read;
        }

        public override void Flush()
        {
        }

        public override long Seek(long offset, SeekOrigin origin) => throw new NotSupportedException();

        public override void SetLength(long value) => throw new NotSupportedException();

        public override void Write(byte[] buffer, int offset, int count) => throw new NotSupportedException();
    }
}
