using System.Runtime.InteropServices.JavaScript;
using System.Text.Json.Nodes;
using Microsoft.CodeAnalysis;
using RigidBodyDynamics.Judging;
using RigidBodyDynamics.Lab.Checking;
using RigidBodyDynamics.Lab.Report;
using RigidBodyDynamics.StudentScripts;

namespace RigidBodyDynamics.Web.Write;

/// <summary>The worker's questions about scripts. Files come as their names, their lengths, and their bytes one after another.</summary>
internal static partial class Scripts
{
    private static readonly LocalRunner Runner = new() { IsRunning = IsRunning, AtWork = AtWork };
    private const int Often = 200;

    private static ScriptReport? _judged;
    private static long _said;

    /// <summary>What prevents running the script: an array of places, from 1, with code and sentences.</summary>
    [JSExport]
    internal static string Errors(string[] names, int[] lengths, byte[] bytes) => Json.Of(Runner.Objections(Json.Files(names, lengths, bytes)).Select(objection =>
    {
        FileLinePositionSpan place = objection.Place.GetLineSpan();
        return new
        {
            file = place.Path,
            line = place.StartLinePosition.Line + 1,
            column = place.StartLinePosition.Character + 1,
            endLine = place.EndLinePosition.Line + 1,
            endColumn = place.EndLinePosition.Character + 1,
            code = objection.Finding.Code,
            en = objection.Finding.English,
            zh = objection.Finding.Chinese,
        };
    }));

    /// <summary>The verdict on a submission, as check gives it: its JSON, and its text in a language.</summary>
    [JSExport]
    internal static string Judge(string[] names, int[] lengths, byte[] bytes, string language) =>
        Said(names[0], Runner.Run(Json.Files(names, lengths, bytes)), language);

    /// <summary>The verdict on a submission whose run was ended from outside.</summary>
    [JSExport]
    internal static string Ended(string[] names, int[] lengths, byte[] bytes, string language, string code) =>
        Said(names[0], Runner.Ended(Json.Files(names, lengths, bytes), code), language);

    /// <summary>The motion of the last judged script, beside the reference and Unity's body; null where it was not run to its end.</summary>
    [JSExport]
    internal static string? Motion() => _judged?.Recording is { } recording ? MotionJson.Of(ScriptMotion.Of(recording)) : null;

    /// <summary>Puts a script on a box at x y z with orientation w x y z, for frames of a length in seconds; returns why it cannot be, or null.</summary>
    [JSExport]
    internal static string? Play(string[] names, int[] lengths, byte[] bytes, double[] edges, double[] position, double[] orientation, double delta)
    {
        Pose pose = new(new Vector(position[0], position[1], position[2]), new Orientation(orientation[1], orientation[2], orientation[3], orientation[0]));
        return Shown(Runner.Play(Json.Files(names, lengths, bytes), new Vector(edges[0], edges[1], edges[2]), pose, delta));
    }

    /// <summary>Plays frames of the script with these keys held; returns a pose of seven numbers for each, fewer where it stops.</summary>
    [JSExport]
    internal static double[] Step(int held, int count) => Runner.Playing?.Step((Keys)held, count) ?? [];

    /// <summary>Why the played script has stopped; null while it plays.</summary>
    [JSExport]
    internal static string? Stopped() => Shown(Runner.Playing?.Stopped);

    private static string? Shown(Finding? finding) => finding == null ? null
        : Json.Of(new { code = finding.Code, en = finding.English, zh = finding.Chinese, line = finding.Line });

    private static string Said(string name, ScriptReport report, string language)
    {
        _judged = report;
        using StringWriter lines = new();
        Console.SetOut(lines);
        Lamps.Print(name, report, isChinese: language == "zh");
        Console.SetOut(TextWriter.Null);
        return Json.Of(new { verdict = JsonNode.Parse(CheckJson.Of(name, report)), lines = lines.ToString(), check = ShownCheck.Of(report), hasMotion = report.Recording != null });
    }

    // the page measures the time from here
    [JSImport("globalThis.scriptRuns")]
    private static partial void Tell(bool isRunning);

    // the page is told a few times in a second
    private static void AtWork()
    {
        if (Environment.TickCount64 - _said > Often)
            IsRunning(true);
    }

    private static void IsRunning(bool isRunning)
    {
        _said = Environment.TickCount64;
        Tell(isRunning);
    }
}
