using RigidBodyDynamics.Lab.Output;

namespace RigidBodyDynamics.Lab.Commands;

/// <summary>What a command says on standard error about the scene that it was given.</summary>
internal static class Notes
{
    /// <summary>Says what the user should know of the scene's bodies, and goes on with it.</summary>
    public static SceneFile Told(this SceneFile file)
    {
        foreach ((string body, IReadOnlyList<string> notes) in file.Notes)
        {
            foreach (string note in notes)
            {
                Terminal.Note($"{file.Path}: {note}, in body \"{body}\"");
            }
        }

        return file;
    }
}
