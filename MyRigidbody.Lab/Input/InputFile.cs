using RigidBodyDynamics.Lab.Output;

namespace RigidBodyDynamics.Lab;

/// <summary>Reads a file of the user; any error is one line.</summary>
internal static class InputFile
{
    private const int Largest = 1 << 28, Spare = 1 << 12;

    public static ArraySegment<byte> Bytes(string path)
    {
        if (path.Length == 0)
            throw new InputException("the name of a file must not be empty");

        try
        {
            if (Directory.Exists(path))
                throw new InputException($"{path}: is a folder, not a file");

            using FileStream file = new(path, FileMode.Open, FileAccess.Read, FileShare.Read, bufferSize: 0);
            // a pipe or a device has no known length, and may not end
            byte[] bytes = new byte[(file.CanSeek ? Math.Min(file.Length, Largest) : 0) + Spare];
            int count = 0;
            for (int read; (read = file.Read(bytes, count, bytes.Length - count)) > 0;)
            {
                count += read;
                if (count > Largest)
                    throw new InputException($"{path}: is larger than {Largest >> 20} MB");

                if (count == bytes.Length)
                    Array.Resize(ref bytes, 2 * count);
            }

            return new ArraySegment<byte>(bytes, 0, count);
        }
        catch (Exception missing) when (missing is FileNotFoundException or DirectoryNotFoundException)
        {
            throw new InputException($"{path}: there is no such file");
        }
        catch (Exception problem) when (problem is IOException or UnauthorizedAccessException or ArgumentException or NotSupportedException)
        {
            throw new InputException($"{path}: cannot be read: {problem.Message.ReplaceLineEndings(" ")}");
        }
    }
}
