using System.CommandLine.Parsing;
using System.Globalization;

namespace RigidBodyDynamics.Lab.Commands;

/// <summary>Numbers on the command line, always with a decimal point: in 1,5 the comma would be read as a separator of thousands.</summary>
internal static class Numbers
{
    /// <summary>The number of an option.</summary>
    public static double Parse(ArgumentResult result)
    {
        string text = result.Tokens[0].Value;
        if (!double.TryParse(text, NumberStyles.Float, CultureInfo.InvariantCulture, out double number))
            result.AddError($"{(result.Parent as OptionResult)?.Option.Name}: must be a number with a decimal point, found {text}");

        return number;
    }
}
