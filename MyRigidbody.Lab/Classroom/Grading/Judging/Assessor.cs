using System.Security.Cryptography;
using System.Text;
using RigidBodyDynamics.Judging;
using RigidBodyDynamics.Lab.Grading.Reading;
using RigidBodyDynamics.StudentScripts;

namespace RigidBodyDynamics.Lab.Grading.Judging;

/// <summary>
/// Finds the script of a submission and has it judged; a script that was judged before, in this run or an earlier one, gets its
/// stored judgement.
/// </summary>
internal sealed class Assessor(IScriptJudge judge, Kept kept)
{
    public Judgement Of(Submission submission)
    {
        if (submission.Problem != null && submission.Scripts.Count == 0)
            return Judgement.Nothing(Mark.Unknown, submission.Problem);

        Script[] scripts = [.. submission.Scripts.Where(script => !script.Spot.Name.Equals("DefaultRigidbody.cs", StringComparison.OrdinalIgnoreCase))];
        if (scripts.Length == 0)
            return Judgement.Nothing(Mark.Missing, Problems.NoScript());

        Script[] named = [.. scripts.Where(Grouping.IsMain)];
        // where none has that name, the judge says what is missing in the likeliest
        Script[] mains = [.. (named.Length > 0 ? named : [scripts.FirstOrDefault(IsOfUnity) ?? scripts[0]]).DistinctBy(script => SourceText.Decode(script.Bytes).Text.ReplaceLineEndings("\n").Trim())];
        Judgement[] judged = [.. mains.Select(main => Judged([main, .. submission.Scripts.Except(mains).Where(script => !IsOfEditor(script))]))];
        return judged.Length == 1 ? judged[0] : Judgement.Between(judged);
    }

    private Judgement Judged(IReadOnlyList<Script> scripts)
    {
        string key = Key(scripts);
        if (kept.Find(key) is Judgement before)
            return before with { File = scripts[0].Spot.Shown, Text = SourceText.Decode(scripts[0].Bytes).Text };

        Judgement judgement = judge.Judge(scripts) with { File = scripts[0].Spot.Shown, Text = SourceText.Decode(scripts[0].Bytes).Text };
        kept.Keep(key, judgement);
        return judgement;
    }

    // Unity compiles them separately from the others
    private static bool IsOfEditor(Script script) => script.Spot.Names.SkipLast(1).Contains("Editor");

    private static bool IsOfUnity(Script script) => SourceText.Decode(script.Bytes).Text.Contains("MonoBehaviour", StringComparison.Ordinal);

    /// <summary>A hash of names and contents; independent of the script's place in the class.</summary>
    private static string Key(IReadOnlyList<Script> scripts)
    {
        using IncrementalHash hash = IncrementalHash.CreateHash(HashAlgorithmName.SHA256);
        foreach (Script script in scripts)
        {
            byte[] name = Encoding.UTF8.GetBytes(script.Spot.Name);
            hash.AppendData(BitConverter.GetBytes(name.Length));
            hash.AppendData(name);
            hash.AppendData(BitConverter.GetBytes(script.Bytes.Length));
            hash.AppendData(script.Bytes);
        }

        return Convert.ToHexStringLower(hash.GetHashAndReset().AsSpan(0, 16));
    }
}
