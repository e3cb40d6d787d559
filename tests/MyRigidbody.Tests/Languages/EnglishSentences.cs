using System.Text.RegularExpressions;

namespace RigidBodyDynamics.Tests.Languages;

/// <summary>Finds English where Chinese is due.</summary>
internal static partial class EnglishSentences
{
    /// <summary>Runs of three or more English words, with the line in which they stand; what stands in quotes is somebody's own.</summary>
    public static IEnumerable<string> In(string text) => text.Split('\n')
        .SelectMany(line => Sentence().Matches(Known().Replace(Quoted().Replace(line, "…"), "…")).Select(match => match.Value)
            // m g l is a product
            .Where(words => words.Split(' ', ',').Any(word => word.Length > 2)).Select(words => words + "   in: " + line));

    [GeneratedRegex(@"(?<![\w/.<-])[A-Za-z]?[a-z']+(,? [a-z']*[A-Za-z]?[a-z']+){2,}(?![\w/>-])")]
    private static partial Regex Sentence();

    [GeneratedRegex("\"[^\"]*\"")]
    private static partial Regex Quoted();

    // names of bodies in our scenes, commands, units, products of inertia, the torque of key R
    [GeneratedRegex(@"quadratic drag|linear damping|on its axle|without a lock|dotnet build|npm install --prefix|bash \.ci|kg m s|slab in Unity|\bi?[wxyz]{1,2}\b|\b(sin|cos) t\b")]
    private static partial Regex Known();
}
