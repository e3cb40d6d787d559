using System.Text;
using Microsoft.Win32.SafeHandles;

namespace RigidBodyDynamics.Lab.Output;

/// <summary>The reader of a pipe has closed it: the rest is not needed, and this is no error.</summary>
internal sealed class ReaderLeftException(Exception cause) : Exception("the reader of standard output has left", cause);

/// <summary>
/// Standard output into a pipe whose reader may close it. The console of .NET ignores that, so <c>run SCENE | head</c> would
/// compute to its end; here the next write throws.
/// </summary>
internal sealed class StandardOutput(Stream pipe) : Stream
{
    private const int Handle = 1, BrokenPipe = 32;

    /// <inheritdoc/>
    public override bool CanRead => false;

    /// <inheritdoc/>
    public override bool CanSeek => false;

    /// <inheritdoc/>
    public override bool CanWrite => true;

    /// <inheritdoc/>
    public override long Length => throw new NotSupportedException();

    /// <inheritdoc/>
    public override long Position { get => throw new NotSupportedException(); set => throw new NotSupportedException(); }

    /// <summary>Standard output as bytes.</summary>
    public static Stream Open() => Pipe() ?? Console.OpenStandardOutput();

    /// <summary>From now on the console writes there, too.</summary>
    public static void Use()
    {
        if (Pipe() is Stream pipe)
            Console.SetOut(new StreamWriter(pipe, new UTF8Encoding(false)) { AutoFlush = true });
    }

    /// <summary>Only a pipe is opened anew; in a file the position must be kept.</summary>
    private static StandardOutput? Pipe()
    {
        if (OperatingSystem.IsWindows() || !Console.IsOutputRedirected)
            return null;

        FileStream stream = new(new SafeFileHandle(Handle, ownsHandle: false), FileAccess.Write, bufferSize: 0);
        return stream.CanSeek ? null : new StandardOutput(stream);
    }

    /// <inheritdoc/>
    public override void Write(byte[] buffer, int offset, int count) => Write(buffer.AsSpan(offset, count));

    /// <inheritdoc/>
    public override void Write(ReadOnlySpan<byte> buffer)
    {
        try
        {
            pipe.Write(buffer);
        }
        catch (IOException left) when (left.HResult == BrokenPipe)
        {
            throw new ReaderLeftException(left);
        }
    }

    /// <inheritdoc/>
    public override void Flush() => pipe.Flush();

    /// <inheritdoc/>
    public override int Read(byte[] buffer, int offset, int count) => throw new NotSupportedException();

    /// <inheritdoc/>
    public override long Seek(long offset, SeekOrigin origin) => throw new NotSupportedException();

    /// <inheritdoc/>
    public override void SetLength(long value) => throw new NotSupportedException();
}
