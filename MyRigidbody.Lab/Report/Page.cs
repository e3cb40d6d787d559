using System.Reflection;
using System.Runtime.InteropServices;
using RigidBodyDynamics.Lab.Languages;

namespace RigidBodyDynamics.Lab.Report;

/// <summary>A page for a browser: its subject, the command that made it, and its sections.</summary>
/// <param name="Name">Its heading.</param>
/// <param name="About">One line about it.</param>
/// <param name="File">Its file, without the folders of the machine.</param>
/// <param name="Command">The arguments of the command line.</param>
/// <param name="Sections">From top to bottom.</param>
internal sealed record Page(Word Name, string About, string File, string Command, IReadOnlyList<Section> Sections)
{
    private const string Program = "dotnet run -c Release --project MyRigidbody.Lab";

    /// <summary>The whole command.</summary>
    public string Line => Command.Length > 0 ? $"{Program} -- {Command}" : Program;

    /// <summary>Its first section, to which the keyboard can jump.</summary>
    public Section First => Sections[0];

    /// <summary>The version of the program.</summary>
    public static string Version =>
        typeof(Page).Assembly.GetCustomAttribute<AssemblyInformationalVersionAttribute>()?.InformationalVersion ?? string.Empty;

    /// <summary>Processors, system, runtime.</summary>
    public static Word Machine => Words.All["facts.processors"].With(
        RuntimeInformation.OSDescription + " " + RuntimeInformation.ProcessArchitecture,
        RuntimeInformation.FrameworkDescription,
        Environment.ProcessorCount);

    /// <summary>A path as the page shows it: as typed, or the file name alone where it contains folders of the machine.</summary>
    public static string Shown(string path)
    {
        string name = Path.IsPathRooted(path) ? Path.GetFileName(path) : path;
        // so that it is not read as an option
        return name.StartsWith('-') ? "./" + name : name;
    }
}

/// <summary>A part of a page; the template has a case for each kind.</summary>
internal abstract record Section
{
    /// <summary>The name of its kind, and of its place in the page.</summary>
    public abstract string Kind { get; }

    /// <summary>Its heading.</summary>
    public Word Title => Words.All[Kind];
}

/// <summary>The moving bodies; the reader controls time, speed and camera.</summary>
/// <param name="Motion">The motion.</param>
internal sealed record Replay(Motion Motion) : Section
{
    /// <inheritdoc/>
    public override string Kind => "replay";

    /// <summary>The parts of the run that are not shown; empty if all of it is.</summary>
    public IReadOnlyList<Word> Left =>
    [
        .. Motion.At.Count <= Motion.Steps.Count ? [Words.All["thinned"].With(Motion.Steps.Count, Motion.At.Count)] : Array.Empty<Word>(),
        .. Motion.Tracks.Count < Motion.BodiesInScene ? [Words.All["fewer.bodies"].With(Motion.BodiesInScene, Motion.Tracks.Count)] : Array.Empty<Word>(),
    ];
}

/// <summary>Curves that follow the time of the replay.</summary>
/// <param name="Label">What they show and where the numbers are, for readers who cannot see them.</param>
internal sealed record TimePlots(Word Label) : Section
{
    /// <inheritdoc/>
    public override string Kind => "plots";
}
