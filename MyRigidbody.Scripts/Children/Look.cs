using RigidBodyDynamics.Judging;
using RigidBodyDynamics.StudentScripts.Comments;
using RigidBodyDynamics.StudentScripts.Compilation;

namespace RigidBodyDynamics.StudentScripts.Children;

/// <summary>The child's answer about a submission before it runs the script.</summary>
/// <param name="File">The script's file; empty where there is none.</param>
/// <param name="Refusals">Why it is not run; empty where it is.</param>
/// <param name="Notes">Other findings.</param>
/// <param name="Comments">Its comments.</param>
/// <param name="Assignments">Which lines assign which variable.</param>
internal sealed record Look(string File, IReadOnlyList<Finding> Refusals, IReadOnlyList<Finding> Notes, CommentCoverage Comments, IReadOnlyList<Assignment> Assignments)
{
    private const int Most = 100_000;

    public static Look At(CompiledScript compiled, Coverage coverage)
    {
        Microsoft.CodeAnalysis.SyntaxTree tree = compiled.Sources.Script!.SyntaxTree;
        return new Look(tree.FilePath, compiled.Refusals, compiled.Notes, coverage.Of(tree), Assignment.In(tree));
    }

    public static Look WithoutScript(Finding why) => new(string.Empty, [why], [], CommentCoverage.None, []);

    public void Write(BinaryWriter to)
    {
        to.Write(File);
        Pipe.Write(to, Refusals);
        Pipe.Write(to, Notes);
        to.Write(Comments.Statements);
        to.Write(Comments.Bare.Count);
        foreach (int line in Comments.Bare)
            to.Write(line);

        to.Write(Assignments.Count);
        foreach (Assignment assignment in Assignments)
        {
            to.Write(assignment.Name);
            to.Write(assignment.Line);
            to.Write(assignment.Damps);
        }
    }

    public static Look Read(BinaryReader from)
    {
        string file = from.ReadString();
        IReadOnlyList<Finding> refusals = Pipe.ReadFindings(from), notes = Pipe.ReadFindings(from);
        int statements = Pipe.Checked(from.ReadInt32(), Most);
        int[] bare = new int[Pipe.Checked(from.ReadInt32(), statements)];
        for (int i = 0; i < bare.Length; i++)
            bare[i] = from.ReadInt32();

        Assignment[] assignments = new Assignment[Pipe.Checked(from.ReadInt32(), Most)];
        for (int i = 0; i < assignments.Length; i++)
            assignments[i] = new Assignment(from.ReadString(), from.ReadInt32(), from.ReadBoolean());

        return new Look(file, refusals, notes, new CommentCoverage(statements, statements - bare.Length, bare), assignments);
    }
}
