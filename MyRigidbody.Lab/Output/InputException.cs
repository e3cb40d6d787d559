namespace RigidBodyDynamics.Lab.Output;

/// <summary>Bad usage or bad input: exit code 2. The message is one whole line, "FILE: PLACE: what is wrong".</summary>
internal sealed class InputException(string message) : Exception(Visible.Line(message, Longest))
{
    // a name in a file may have any length; its line must stay readable
    private const int Longest = 1000;
}
