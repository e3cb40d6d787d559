using System.Buffers.Binary;
using System.IO.Hashing;
using SkiaSharp;

namespace RigidBodyDynamics.Lab.Animation;

/// <summary>
/// An animated PNG (APNG): every browser and most slide programs show it. The pictures are compressed as any PNG; this class
/// writes the chunks around them, as in the third edition of the PNG specification, chapter 11.3.6.
/// </summary>
internal sealed class AnimatedPng
{
    private const int ChunkHead = 8, ChunkEnd = 4;
    private static readonly byte[] Signature = [0x89, (byte)'P', (byte)'N', (byte)'G', 13, 10, 26, 10];

    // half the time of the default, for a twentieth more bytes
    private static readonly SKPngEncoderOptions Quick = new(SKPngEncoderFilterFlags.Up, 5);

    private readonly MemoryStream _pictures = new();
    private readonly int _width, _height;
    private readonly ushort _hundredths;
    private byte[] _header = [];
    private int _count;
    private uint _sequence;

    /// <summary>Pictures of one size, each shown for some hundredths of a second.</summary>
    public AnimatedPng(int width, int height, int hundredths)
    {
        _width = width;
        _height = height;
        _hundredths = (ushort)hundredths;
    }

    /// <summary>Adds a picture.</summary>
    public void Add(SKImage picture)
    {
        using SKPixmap pixels = picture.PeekPixels() ?? throw new ArgumentException("picture: must have its pixels in memory", nameof(picture));
        using SKData png = pixels.Encode(Quick)!;
        ReadOnlySpan<byte> bytes = png.AsSpan();
        Control();
        for (int at = Signature.Length; at < bytes.Length;)
        {
            int length = BinaryPrimitives.ReadInt32BigEndian(bytes[at..]);
            ReadOnlySpan<byte> name = bytes.Slice(at + 4, 4), content = bytes.Slice(at + ChunkHead, length);
            if (name.SequenceEqual("IHDR"u8))
                _header = content.ToArray();
            else if (name.SequenceEqual("IDAT"u8))
                Data(content);

            at += ChunkHead + length + ChunkEnd;
        }

        _count++;
    }

    /// <summary>The whole file.</summary>
    public byte[] ToArray()
    {
        MemoryStream file = new();
        file.Write(Signature);
        Chunk(file, "IHDR"u8, _header);
        byte[] animation = new byte[8];
        BinaryPrimitives.WriteInt32BigEndian(animation, _count); // followed by the number of repetitions: 0, without end
        Chunk(file, "acTL"u8, animation);
        _pictures.WriteTo(file);
        Chunk(file, "IEND"u8, []);
        return file.ToArray();
    }

    // the part of the picture that is replaced (all of it), and its duration
    private void Control()
    {
        byte[] control = new byte[26];
        BinaryPrimitives.WriteUInt32BigEndian(control, _sequence++);
        BinaryPrimitives.WriteInt32BigEndian(control.AsSpan(4), _width);
        BinaryPrimitives.WriteInt32BigEndian(control.AsSpan(8), _height);
        BinaryPrimitives.WriteUInt16BigEndian(control.AsSpan(20), _hundredths);
        BinaryPrimitives.WriteUInt16BigEndian(control.AsSpan(22), 100);
        Chunk(_pictures, "fcTL"u8, control);
    }

    // the first picture is stored as in a PNG without animation, for programs that know no other
    private void Data(ReadOnlySpan<byte> content)
    {
        if (_count == 0)
        {
            Chunk(_pictures, "IDAT"u8, content);
            return;
        }

        byte[] numbered = new byte[4 + content.Length];
        BinaryPrimitives.WriteUInt32BigEndian(numbered, _sequence++);
        content.CopyTo(numbered.AsSpan(4));
        Chunk(_pictures, "fdAT"u8, numbered);
    }

    private static void Chunk(Stream to, ReadOnlySpan<byte> name, ReadOnlySpan<byte> content)
    {
        Span<byte> number = stackalloc byte[4];
        BinaryPrimitives.WriteInt32BigEndian(number, content.Length);
        to.Write(number);
        to.Write(name);
        to.Write(content);
        Crc32 sum = new();
        sum.Append(name);
        sum.Append(content);
        BinaryPrimitives.WriteUInt32BigEndian(number, sum.GetCurrentHashAsUInt32());
        to.Write(number);
    }
}
