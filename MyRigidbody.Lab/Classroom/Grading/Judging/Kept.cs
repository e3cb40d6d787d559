using System.Text.Json;
using System.Text.Json.Serialization;
using RigidBodyDynamics.Judging;
using RigidBodyDynamics.Lab.Output;

namespace RigidBodyDynamics.Lab.Grading.Judging;

/// <summary>
/// Judgements stored by the content of their scripts, one file each, so that an interrupted run continues and a second run judges
/// only new scripts. Another version of the judge or another starter has a folder of its own.
/// </summary>
internal sealed class Kept
{
    private static readonly JsonSerializerOptions Options = new() { Converters = { new JsonStringEnumConverter() } };

    private readonly string _folder;

    /// <summary>The judgements stored in a folder.</summary>
    /// <param name="folder">The folder for all versions.</param>
    /// <param name="version">Of everything else on which a judgement depends.</param>
    public Kept(string folder, string version)
    {
        _folder = Path.Combine(folder, version);
        try
        {
            Directory.CreateDirectory(_folder);
        }
        catch (Exception problem) when (problem is IOException or UnauthorizedAccessException)
        {
            throw new InputException($"--out: cannot be written: {problem.Message.ReplaceLineEndings(" ")}");
        }
    }

    /// <summary>The stored judgement; null where there is none, or its file is damaged.</summary>
    public Judgement? Find(string key)
    {
        try
        {
            return JsonSerializer.Deserialize<Stored>(File.ReadAllBytes(Of(key)), Options)?.Judgement;
        }
        catch (Exception missing) when (missing is IOException or UnauthorizedAccessException or JsonException or ArgumentException)
        {
            return null;
        }
    }

    /// <summary>Stores a judgement; completely or not at all, even if the process ends.</summary>
    public void Keep(string key, Judgement judgement)
    {
        string temporary = Path.Combine(_folder, $".{Guid.NewGuid():N}");
        try
        {
            File.WriteAllBytes(temporary, JsonSerializer.SerializeToUtf8Bytes(Stored.Of(judgement), Options));
            File.Move(temporary, Of(key), overwrite: true);
        }
        catch (Exception full) when (full is IOException or UnauthorizedAccessException)
        {
            throw new InputException($"--out: cannot be written: {full.Message.ReplaceLineEndings(" ")}");
        }
    }

    private string Of(string key) => Path.Combine(_folder, key + ".json");

    private sealed record Stored(Outcome Outcome, Mark[] Marks, StoredFinding[] Findings, int Statements, int[] Uncommented)
    {
        [JsonIgnore]
        public Judgement Judgement
        {
            get
            {
                Finding[] findings = [.. Findings.Select(finding => finding.Finding)];
                Verdict verdict = Outcome == Outcome.Refused
                    ? Verdict.Refused(findings)
                    : new Verdict(Verdict.FiveSteps.Zip(Marks).ToDictionary(pair => pair.First, pair => pair.Second), findings);
                return new Judgement(verdict, Statements, Uncommented, null, string.Empty);
            }
        }

        public static Stored Of(Judgement judgement) => new(
            judgement.Verdict.Outcome,
            [.. Verdict.FiveSteps.Select(step => judgement.Verdict[step])],
            [.. judgement.Verdict.Findings.Select(StoredFinding.Of)],
            judgement.Statements,
            [.. judgement.Uncommented]);
    }

    private sealed record StoredFinding(
        Step Step, string Code, string Expected, string Found, string English, string Chinese, bool IsDoubtful, int? Line, string? Experiment, int? Since)
    {
        [JsonIgnore]
        public Finding Finding
        {
            get
            {
                Finding finding = new(Step, Code, Expected, Found, English, Chinese);
                finding = Line is int line ? finding.At(line) : finding;
                finding = Since is int frame ? finding.From(Experiment, frame) : finding;
                return IsDoubtful ? finding.ForInstructor() : finding;
            }
        }

        public static StoredFinding Of(Finding from) => new(
            from.Step, from.Code, from.Expected, from.Found, from.English, from.Chinese, from.IsDoubtful, from.Line, from.Experiment, from.Since);
    }
}
