namespace RigidBodyDynamics.Mutants;

/// <summary>The result of a test on the unchanged Core: its duration, and the marks it sets.</summary>
internal sealed record KnownTest(string Fixture, string Name, double Milliseconds, int[] Marks);

/// <summary>Marks set by all tests, and those set once for all of them: when types are first used, when cases are listed.</summary>
internal sealed record Coverage(KnownTest[] Tests, int[] Once, string[] Failing);

/// <summary>Tests to be run one after another, and the time after which they will not come to an end any more.</summary>
internal sealed record Batch(string[] Fixtures, string[] Tests, double Milliseconds);

/// <summary>An errand for a worker: a Core in a file, and the tests it is to be put to. Without batches, the marks are read.</summary>
internal sealed record Errand(string Core, string TestFolder, Batch[] Batches);

/// <summary>The test that failed; nothing where all passed.</summary>
internal sealed record Verdict(string? Failed, bool TimedOut, long Memory);
