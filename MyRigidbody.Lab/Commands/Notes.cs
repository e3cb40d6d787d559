using RigidBodyDynamics.Lab.Output;

namespace RigidBodyDynamics.Lab.Commands;

/// <summary>The notes of a command about its scene, on standard error.</summary>
internal static class Notes
{
    /// <summary>Prints the notes about the scene's bodies, and returns it.</summary>
    public static SceneFile Told(this SceneFile file)
    {
        foreach ((string body, IReadOnlyList<string> notes) in file.Notes)
        {
            foreach (string note in notes)
                Terminal.Note($"{file.Path}: {note}, in body \"{body}\"");
        }

        return file;
    }
}
