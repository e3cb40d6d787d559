using System.Runtime.ExceptionServices;
using RigidBodyDynamics.Lab.Grading.Judging;
using RigidBodyDynamics.Lab.Grading.Marks;
using RigidBodyDynamics.Lab.Grading.Reading;
using RigidBodyDynamics.Lab.Grading.Students;
using RigidBodyDynamics.Lab.Output;

namespace RigidBodyDynamics.Lab.Grading;

/// <summary>Grades a class: reads the submissions, and has them judged on all cores.</summary>
/// <param name="bench">Judges of the scripts, and what they depend on.</param>
internal sealed class Grader(IBench bench)
{
    /// <summary>The folder of stored judgements.</summary>
    public const string KeptFolder = ".grade";

    /// <summary>Reads and judges.</summary>
    /// <param name="paths">Files and folders as typed.</param>
    /// <param name="output">The folder for the results.</param>
    /// <param name="roster">The class list; null where there is none.</param>
    /// <param name="marks">Points and decisions.</param>
    /// <param name="report">Receives the name of the present part.</param>
    public Class Judge(IReadOnlyList<string> paths, string output, Roster? roster, MarksFile marks, Action<double> report)
    {
        HandedIn handedIn = HandedIn.Read(paths, output);
        IReadOnlyList<Submission> submissions = Grouping.Of(handedIn, roster);
        if (submissions.Count == 0)
            throw new InputException($"{paths[0]}: there is no script, package or archive in it");

        Kept kept = new(Path.Combine(output, KeptFolder), bench.Version);
        (Submission, Judgement)[] judged = new (Submission, Judgement)[submissions.Count];
        int next = -1, done = 0;
        OnAllCores(Math.Min(submissions.Count, Environment.ProcessorCount), () =>
        {
            using IScriptJudge judge = bench.NewJudge();
            Assessor assessor = new(judge, kept);
            for (int i = Interlocked.Increment(ref next); i < submissions.Count; i = Interlocked.Increment(ref next))
            {
                judged[i] = (submissions[i], assessor.Of(submissions[i]));
                report((double)Interlocked.Increment(ref done) / submissions.Count);
            }
        });
        string name = string.Join(", ", paths.Select(path => Path.GetFileName(Path.TrimEndingDirectorySeparator(Path.GetFullPath(path)))).Take(3)) + (paths.Count > 3 ? ", …" : string.Empty);
        return Class.Of(name, handedIn, judged, roster, marks, bench.Starter);
    }

    private static void OnAllCores(int cores, Action work)
    {
        Exception? failed = null;
        Thread[] threads = [.. Enumerable.Range(0, cores).Select(_ => new Thread(() =>
        {
            try
            {
                work();
            }
            catch (Exception exception)
            {
                // an exception ends the run; the first one is reported
                Interlocked.CompareExchange(ref failed, exception, null);
            }
        }))];
        Array.ForEach(threads, thread => thread.Start());
        Array.ForEach(threads, thread => thread.Join());
        if (failed != null)
            ExceptionDispatchInfo.Throw(failed);
    }
}
