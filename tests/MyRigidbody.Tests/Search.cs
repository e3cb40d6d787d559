namespace RigidBodyDynamics.Tests;

/// <summary>
/// How widely tests search. By hand they try a sample, the same in every run; where MYRIGIDBODY_SEARCH is <c>whole</c>, as in .ci/run, what
/// their names say; where it is <c>all</c>, every variation and every small change of a script too, which takes half an hour.
/// </summary>
internal static class Search
{
    private static readonly string? Asked = Environment.GetEnvironmentVariable("MYRIGIDBODY_SEARCH");

    /// <summary>All that there is, though it takes half an hour.</summary>
    public static bool IsAll => Asked == "all";

    /// <summary>What a check before a pull request asks for.</summary>
    public static bool IsWhole => IsAll || Asked == "whole";

    /// <summary>The whole, or the count that is enough of a sample.</summary>
    public static int Count(int whole, int sample) => IsWhole ? whole : sample;

    /// <summary>All of them, or one of each so many that follow one another.</summary>
    public static T[] In<T>(IEnumerable<T> all, int oneIn)
    {
        Random drawn = new(1);
        return [.. IsWhole ? all : all.Chunk(oneIn).Select(some => some[drawn.Next(some.Length)])];
    }
}
