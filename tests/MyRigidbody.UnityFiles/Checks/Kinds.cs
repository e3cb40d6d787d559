using System.Globalization;
using System.Text.RegularExpressions;
using YamlDotNet.RepresentationModel;

namespace RigidBodyDynamics.UnityFiles.Checks;

/// <summary>Whether a value is of a kind, as far as that can be said without knowing the other objects.</summary>
internal static partial class Kinds
{
    // a rotation of another length is turned into one of length 1 by the engine, or into none
    private const double OfLengthOne = 1e-5;

    /// <summary>True, or false, or null for a kind that is a reference.</summary>
    public static bool? Fits(YamlNode value, string kind) => kind switch
    {
        "int" => value is YamlScalarNode && Whole().IsMatch(value.Text()),
        "bool" => value is YamlScalarNode { Value: "0" or "1" },
        "float" => IsFloat(value),
        "text" => value is YamlScalarNode,
        "vector2" => HasFloats(value, "x", "y"),
        "vector3" => HasFloats(value, "x", "y", "z"),
        "vector4" => HasFloats(value, "x", "y", "z", "w"),
        "rotation" => HasFloats(value, "x", "y", "z", "w") && Math.Abs(value.Rotation().Length() - 1) < OfLengthOne,
        "color" => HasFloats(value, "r", "g", "b", "a"),
        _ when kind.StartsWith('=') => value is YamlScalarNode && value.Text() == kind[1..],
        _ when kind.StartsWith("one of ", StringComparison.Ordinal) => value is YamlScalarNode && Whole().IsMatch(value.Text())
            && long.Parse(value.Text(), CultureInfo.InvariantCulture) is long number && number >= 0
            && number < long.Parse(kind[7..], CultureInfo.InvariantCulture),
        _ => null,
    };

    private static bool IsFloat(YamlNode value) => value is YamlScalarNode && Real().IsMatch(value.Text());

    private static bool HasFloats(YamlNode value, params string[] names) =>
        value is YamlMappingNode mapping && mapping.Children.Select(pair => pair.Key.Text()).SequenceEqual(names) && mapping.Children.All(pair => IsFloat(pair.Value));

    [GeneratedRegex(@"^-?\d{1,18}$")]
    private static partial Regex Whole();

    [GeneratedRegex(@"^-?\d+(\.\d+)?(e[-+]?\d+)?$")]
    private static partial Regex Real();
}
