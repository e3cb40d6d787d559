using System.Diagnostics;
using Microsoft.CodeAnalysis;
using Microsoft.CodeAnalysis.CSharp.Syntax;
using RigidBodyDynamics.Judging;
using RigidBodyDynamics.StudentScripts.Compilation;
using RigidBodyDynamics.StudentScripts.Metering;

namespace RigidBodyDynamics.StudentScripts.Running;

/// <summary>Runs a script through the judge's experiments.</summary>
internal static class Execution
{
    private const int StackBytes = 1 << 20;

    static Execution() => AppDomain.CurrentDomain.FirstChanceException += (_, thrown) =>
    {
        // a script that catches these would continue; the meter remembers them
        if (thrown.Exception is OutOfMemoryException)
            Meter.Stop(Stopped.Memory);
        else if (thrown.Exception is InsufficientExecutionStackException)
            Meter.Stop(Stopped.Recursion);
    };

    /// <summary>Runs on a thread of its own, whose small stack soon shows endless recursion.</summary>
    public static RunOutcome RunOnThread(CompiledScript compiled)
    {
        RunOutcome? outcome = null;
        Thread thread = new(() => outcome = Run(compiled, () => { }), StackBytes);
        thread.Start();
        thread.Join();
        return outcome!;
    }

    /// <summary>Runs on the caller's thread.</summary>
    public static RunOutcome Run(CompiledScript compiled, Action afterFrame)
    {
        using StandIn laboratory = new(compiled, afterFrame);
        Recording? recording = null;
        Finding? stopped = Try(compiled, laboratory, () => recording = Experiments.Record(laboratory));
        return stopped == null ? new RunOutcome(recording, null) : new RunOutcome(null, stopped);
    }

    /// <summary>Lets a script do something; returns why it did not finish, or null if it did.</summary>
    public static Finding? Try(CompiledScript compiled, StandIn laboratory, Action work)
    {
        Meter.Reset();
        try
        {
            work();
            return null;
        }
        catch (ScriptException thrown)
        {
            return Thrown(thrown.InnerException!, laboratory, compiled);
        }
        catch (Exception stopped) when (stopped is StoppedException or OutOfMemoryException or InsufficientExecutionStackException)
        {
            return WasStopped(laboratory, compiled);
        }
        catch (Exception broken)
        {
            // a script that destroys its object, for instance, removes what the judge reads
            return Place(Words.Stopped("ended", broken.GetType().Name), null, laboratory);
        }
    }

    private static Finding WasStopped(StandIn laboratory, CompiledScript compiled)
    {
        int? line = Meter.Line > 0 ? Meter.Line : null;
        string code = Meter.Reason switch
        {
            Stopped.Recursion => "endless-recursion",
            Stopped.Memory => "memory",
            _ => IsInLoopThatCatches(line, compiled) ? "endless-loop-that-catches" : "endless-loop",
        };
        return Place(Words.Stopped(code, code == "memory" ? compiled.ClassName : laboratory.Message), line, laboratory);
    }

    private static Finding Thrown(Exception thrown, StandIn laboratory, CompiledScript compiled)
    {
        int? line = Line(thrown);
        string[] lines = compiled.Sources.Script!.SyntaxTree.ToString().Split('\n');
        bool isRigidbody = thrown is NullReferenceException && line is { } at && at <= lines.Length && lines[at - 1].Contains("Rigidbody", StringComparison.Ordinal);
        return Place(Words.Throws(isRigidbody ? "no-rigidbody" : "throws", laboratory.Message, thrown.GetType().Name, MessageOf(thrown)), line, laboratory);
    }

    private static Finding Place(Finding finding, int? line, StandIn laboratory)
    {
        Finding placed = laboratory.FramesDone > 0 ? finding.From(string.Empty, laboratory.FramesDone) : finding;
        return line is { } known ? placed.At(known) : placed;
    }

    // the innermost line of the script; where the runtime cannot find it, that of the last statement begun
    private static int? Line(Exception thrown) => new StackTrace(thrown, fNeedFileInfo: true).GetFrames()
        .Where(frame => frame.GetFileLineNumber() > 0 && StandIn.IsOfScript(frame.GetMethod()?.DeclaringType?.Assembly))
        .Select(frame => (int?)frame.GetFileLineNumber())
        .FirstOrDefault() ?? (OperatingSystem.IsBrowser() && Meter.Here > 0 ? Meter.Here : null);

    private static bool IsInLoopThatCatches(int? line, CompiledScript compiled)
    {
        if (line == null)
            return false;

        SyntaxTree tree = compiled.Sources.Script!.SyntaxTree;
        return tree.GetRoot().DescendantNodes().OfType<StatementSyntax>()
            .Where(statement => statement is WhileStatementSyntax or DoStatementSyntax or ForStatementSyntax)
            .Any(loop => loop.DescendantNodes().OfType<CatchClauseSyntax>().Any() && Spans(loop, line.Value));
    }

    private static bool Spans(SyntaxNode node, int line)
    {
        FileLinePositionSpan span = node.GetLocation().GetLineSpan();
        return span.StartLinePosition.Line < line && line <= span.EndLinePosition.Line + 1;
    }

    // a message can be the script's own code
    private static string MessageOf(Exception thrown)
    {
        try
        {
            return ": " + thrown.Message.Split('\n')[0].TrimEnd('\r', '.');
        }
        catch (Exception)
        {
            return string.Empty;
        }
    }
}
