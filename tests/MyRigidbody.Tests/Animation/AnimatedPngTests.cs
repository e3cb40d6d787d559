using System.Buffers.Binary;
using System.IO.Compression;
using NUnit.Framework;
using RigidBodyDynamics.Lab;
using RigidBodyDynamics.Lab.Animation;
using RigidBodyDynamics.Lab.Comparison;
using RigidBodyDynamics.Lab.Report;
using RigidBodyDynamics.Tests.CommandLine;
using SkiaSharp;

namespace RigidBodyDynamics.Tests.Animation;

/// <summary>The animated picture chunk by chunk, as the PNG specification has it.</summary>
public sealed class AnimatedPngTests
{
    private static readonly SKColor[] Colors = [SKColors.Red, SKColors.Lime, SKColors.Blue];

    [Test]
    public void Three_pictures_make_a_PNG_whose_chunks_are_sound_and_in_order()
    {
        (string Name, byte[] Content)[] chunks = [.. Chunks(Three())];

        Assert.That(chunks.Select(chunk => chunk.Name), Is.EqualTo(new[] { "IHDR", "acTL", "fcTL", "IDAT", "fcTL", "fdAT", "fcTL", "fdAT", "IEND" }));
        Assert.That(chunks[1].Content, Is.EqualTo(new byte[] { 0, 0, 0, 3, 0, 0, 0, 0 }), "three pictures, for ever");
        Assert.That(
            chunks.Where(chunk => chunk.Name is "fcTL" or "fdAT").Select(chunk => BinaryPrimitives.ReadInt32BigEndian(chunk.Content)),
            Is.EqualTo(Enumerable.Range(0, 5)));
    }

    [Test]
    public void Every_picture_has_its_own_colors_and_stays_for_its_time()
    {
        (string Name, byte[] Content)[] chunks = [.. Chunks(Three())];
        byte[][] data = [.. chunks.Where(chunk => chunk.Name is "IDAT" or "fdAT").Select(chunk => chunk.Name == "IDAT" ? chunk.Content : chunk.Content[4..])];

        for (int i = 0; i < Colors.Length; i++)
        {
            using ZLibStream rows = new(new MemoryStream(data[i]), CompressionMode.Decompress);
            byte[] first = new byte[5];
            rows.ReadExactly(first);
            // a row's filter, of which none can change its first pixel, then red, green, blue, alpha or only three of them
            Assert.That(first[1..4], Is.EqualTo(new[] { Colors[i].Red, Colors[i].Green, Colors[i].Blue }));
        }

        foreach (byte[] control in chunks.Where(chunk => chunk.Name == "fcTL").Select(chunk => chunk.Content))
            Assert.That((BinaryPrimitives.ReadInt16BigEndian(control.AsSpan(20)), BinaryPrimitives.ReadInt16BigEndian(control.AsSpan(22))), Is.EqualTo((7, 100)));
    }

    [Test]
    public void Program_that_knows_no_animation_sees_the_first_picture()
    {
        using SKBitmap seen = SKBitmap.Decode(Three());

        Assert.That((seen.Width, seen.Height, seen.GetPixel(3, 2)), Is.EqualTo((8, 6, SKColors.Red)));
    }

    [Test]
    public void Replay_of_the_lab_takes_ten_seconds_and_no_two_of_its_pictures_are_the_same()
    {
        using TemporaryFolder folder = new();
        SceneFile lab = SceneReader.Read(Gallery.Lab);
        ReplayPicture.Write("lab", Motion.Of(lab, [Findings.Of(Pair.Of(lab)[0], lab.Scene.Steps, _ => { })]), folder.File("replay.png"));
        (string Name, byte[] Content)[] chunks = [.. Chunks(File.ReadAllBytes(folder.File("replay.png")))];
        int pictures = BinaryPrimitives.ReadInt32BigEndian(chunks[1].Content);
        double seconds = chunks.Where(chunk => chunk.Name == "fcTL").Sum(chunk => BinaryPrimitives.ReadInt16BigEndian(chunk.Content.AsSpan(20)) / 100.0);

        Assert.That(seconds, Is.EqualTo(10).Within(1));
        Assert.That(
            chunks.Where(chunk => chunk.Name is "IDAT" or "fdAT").Select(chunk => Convert.ToHexString(chunk.Name == "IDAT" ? chunk.Content : chunk.Content[4..])).Distinct().Count(),
            Is.GreaterThanOrEqualTo(pictures));
    }

    private static byte[] Three()
    {
        AnimatedPng png = new(8, 6, 7);
        foreach (SKColor color in Colors)
        {
            using SKSurface surface = SKSurface.Create(new SKImageInfo(8, 6, SKColorType.Rgba8888, SKAlphaType.Opaque));
            surface.Canvas.Clear(color);
            using SKImage image = surface.Snapshot();
            png.Add(image);
        }

        return png.ToArray();
    }

    private static IEnumerable<(string Name, byte[] Content)> Chunks(byte[] file)
    {
        for (int at = 8; at < file.Length;)
        {
            int length = BinaryPrimitives.ReadInt32BigEndian(file.AsSpan(at));
            byte[] named = file[(at + 4)..(at + 8 + length)];
            Assert.That(BinaryPrimitives.ReadUInt32BigEndian(file.AsSpan(at + 8 + length)), Is.EqualTo(System.IO.Hashing.Crc32.HashToUInt32(named)));
            yield return (System.Text.Encoding.ASCII.GetString(named, 0, 4), named[4..]);
            at += 12 + length;
        }
    }
}
