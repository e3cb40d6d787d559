namespace RigidBodyDynamics.Lab;

/// <summary>Bad usage or bad input: exit code 2. The message is one whole line, "FILE: PLACE: what is wrong".</summary>
internal sealed class InputException(string message) : Exception(OneLine(message))
{
    private const int Longest = 1000;

    /// <summary>A name in a file may hold any character and be of any length; the line it is shown in stays one that can be read.</summary>
    private static string OneLine(string message) =>
        string.Concat(message.Take(Longest).Select(letter => char.IsControl(letter) || letter is '\u2028' or '\u2029' ? ' ' : letter))
            + (message.Length > Longest ? "…" : string.Empty);
}
