using System.Security.Cryptography;
using System.Text;
using RigidBodyDynamics.Lab.Grading.Reading;
using RigidBodyDynamics.StudentScripts;

namespace RigidBodyDynamics.Lab.Grading.Judging;

/// <summary>Has scripts run by child processes, one for each judge.</summary>
/// <param name="starter">The text that students received; null for the sheet's.</param>
internal sealed class ScriptBench(string? starter) : IBench
{
    // digits of the hash, enough to be unique
    private const int VersionLength = 16;

    /// <inheritdoc/>
    public string Starter => starter ?? ScriptRunner.SheetStarter;

    /// <summary>A hash of everything that a verdict depends on: the program's own assemblies, and the starter.</summary>
    public string Version
    {
        get
        {
            using IncrementalHash hash = IncrementalHash.CreateHash(HashAlgorithmName.SHA256);
            // a single-file program contains its assemblies
            string[] files = Directory.GetFiles(AppContext.BaseDirectory, "MyRigidbody.*.dll") is { Length: > 0 } assemblies ? assemblies : [Environment.ProcessPath!];
            foreach (string file in files.Order(StringComparer.Ordinal))
                hash.AppendData(File.ReadAllBytes(file));

            hash.AppendData(Encoding.UTF8.GetBytes(Starter));
            return Convert.ToHexStringLower(hash.GetHashAndReset())[..VersionLength];
        }
    }

    /// <inheritdoc/>
    public IScriptJudge NewJudge() => new Judge(new ScriptRunner(starter));

    private sealed class Judge(ScriptRunner runner) : IScriptJudge
    {
        Judgement IScriptJudge.Judge(IReadOnlyList<Script> scripts)
        {
            ScriptReport report = runner.Run([.. scripts.Select(script => new ScriptFile(InPackage(script.Spot.Shown), script.Bytes))]);
            return new Judgement(report.Verdict, report.Comments.Statements, report.Comments.Bare, null, report.Text);
        }

        public void Dispose() => runner.Dispose();

        private static string InPackage(string shown) => shown[(shown.LastIndexOf('!') + 1)..];
    }
}
