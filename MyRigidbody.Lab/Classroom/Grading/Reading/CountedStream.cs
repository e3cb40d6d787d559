namespace RigidBodyDynamics.Lab.Grading.Reading;

/// <summary>An archive unpacks to more than the limit.</summary>
internal sealed class TooLargeException(long limit) : Exception
{
    /// <summary>The limit, bytes.</summary>
    public long Limit { get; } = limit;
}

/// <summary>Counts the bytes that are read, because the sizes stated in an archive may be false.</summary>
internal sealed class CountedStream(Stream inner, long limit) : Stream
{
    private long _count;

    public override bool CanRead => true;

    public override bool CanSeek => false;

    public override bool CanWrite => false;

    public override long Length => throw new NotSupportedException();

    public override long Position { get => _count; set => throw new NotSupportedException(); }

    /// <summary>The rest of the stream as bytes.</summary>
    public static byte[] ReadAll(Stream stream, long limit)
    {
        using CountedStream counted = new(stream, limit);
        MemoryStream bytes = new();
        counted.CopyTo(bytes);
        return bytes.ToArray();
    }

    public override int Read(byte[] buffer, int offset, int count) => Counted(inner.Read(buffer, offset, count));

    public override int Read(Span<byte> buffer) => Counted(inner.Read(buffer));

    public override void Flush() => throw new NotSupportedException();

    public override long Seek(long offset, SeekOrigin origin) => throw new NotSupportedException();

    public override void SetLength(long value) => throw new NotSupportedException();

    public override void Write(byte[] buffer, int offset, int count) => throw new NotSupportedException();

    private int Counted(int read)
    {
        if ((_count += read) > limit)
            throw new TooLargeException(limit);

        return read;
    }
}
