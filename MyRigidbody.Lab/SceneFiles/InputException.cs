namespace RigidBodyDynamics.Lab;

/// <summary>Bad usage or bad input: exit code 2. The message is one whole line, "FILE: PLACE: what is wrong".</summary>
internal sealed class InputException(string message) : Exception(OneLine(message))
{
    /// <summary>A name in a file may hold any character; the line it is shown in stays one.</summary>
    private static string OneLine(string message) =>
        string.Concat(message.Select(letter => char.IsControl(letter) || letter is '\u2028' or '\u2029' ? ' ' : letter));
}
