using System.Globalization;
using System.Xml.Linq;
using RigidBodyDynamics.Lab.Output;

namespace RigidBodyDynamics.Lab.Inertia.Robots;

/// <summary>Numbers in attributes of a robot description; an invalid one is refused with its line.</summary>
/// <param name="File">The file, as typed.</param>
internal sealed record Attributes(string File)
{
    private const int MostShown = 60;

    /// <summary>A required number.</summary>
    public double Number(XElement element, string name) =>
        Numbers(element, name, 1, 1)?[0] ?? throw Wrong(element, $"{name} is missing");

    /// <summary>A number, or a default.</summary>
    public double Number(XElement? element, string name, double otherwise) =>
        element == null ? otherwise : Numbers(element, name, 1, 1)?[0] ?? otherwise;

    /// <summary>Three numbers; null if there are none.</summary>
    public Vector3d? Vector(XElement? element, string name) =>
        element != null && Numbers(element, name, 3, 3) is double[] n ? new Vector3d(n[0], n[1], n[2]) : null;

    /// <summary>Numbers separated by blanks; null if the attribute is absent.</summary>
    public double[]? Numbers(XElement element, string name, int fewest, int most) =>
        element.Attribute(name) is XAttribute attribute ? Numbers(element, name, attribute.Value, fewest, most) : null;

    /// <summary>Numbers in a text of an attribute.</summary>
    public double[] Numbers(XElement element, string name, string text, int fewest, int most)
    {
        string[] words = text.Split((char[]?)null, StringSplitOptions.RemoveEmptyEntries);
        if (words.Length < fewest || words.Length > most)
            throw Wrong(element, $"{name} must have {(fewest == most ? $"{fewest}" : $"{fewest} to {most}")} number{(most == 1 ? string.Empty : "s")}, found \"{Shown(text)}\"{Xacro(text)}");

        double[] numbers = new double[words.Length];
        for (int i = 0; i < words.Length; i++)
        {
            if (!double.TryParse(words[i], NumberStyles.Float, CultureInfo.InvariantCulture, out numbers[i]) || !double.IsFinite(numbers[i]))
                throw Wrong(element, $"{name} must have finite numbers, found \"{Shown(words[i])}\"{Xacro(text)}");
        }

        return numbers;
    }

    /// <summary>The error at an element.</summary>
    public InputException Wrong(XElement element, string what) => XmlFile.Wrong(File, element, $"{Shown(element.Name.LocalName)}: {what}");

    private static string Shown(string text) => text.Length <= MostShown ? text : text[..MostShown] + "…";

    private static string Xacro(string text) =>
        text.Contains("${", StringComparison.Ordinal) ? ": this is xacro, which must be expanded first (xacro FILE > FILE.urdf)" : string.Empty;
}
