using System.Text.RegularExpressions;
using RigidBodyDynamics.UnityFiles.Shading;
using YamlDotNet.RepresentationModel;

namespace RigidBodyDynamics.UnityFiles.Checks;

/// <summary>
/// The shaders: drawn by the built-in pipeline, URP and HDRP alike, with what every pipeline's projects have, and set by materials
/// that have just their properties.
/// </summary>
internal static partial class Shaders
{
    // Unity's manual, "ShaderLab: assigning tags"; a tag RenderPipeline would bind a shader to one of them
    private static readonly string[] TagsOfSubShaders = ["RenderType", "Queue"], TagsOfPasses = ["LightMode"];
    private static readonly string[] InPasses = ["Name", "Tags", "ColorMask", "CGPROGRAM"], ColorMasks = ["R", "0"];

    // one pass that every pipeline draws, and those that URP wants in the depth buffer and for SSAO
    private static readonly string?[] Passes = [null, "DepthOnly", "DepthNormals"];

    // in projects of every pipeline
    private static readonly string[] Includes = ["UnityCG.cginc"], Types = ["Color"];

    /// <summary>What is wrong.</summary>
    public static IEnumerable<string> Findings(Project project)
    {
        Dictionary<string, ShaderFile> shaders = [];
        foreach ((string path, string text) in project.Files.Texts.Where(file => file.Key.EndsWith(".shader", StringComparison.Ordinal)))
        {
            string[] findings;
            try
            {
                ShaderFile shader = ShaderFile.Parse(text);
                shaders.Add(path, shader);
                findings = [.. Of(shader)];
            }
            catch (FormatException wrong)
            {
                findings = [wrong.Message];
            }

            foreach (string finding in findings)
                yield return $"{path}: {finding}";
        }

        foreach (IGrouping<string, string> same in shaders.GroupBy(shader => shader.Value.Name, shader => shader.Key).Where(group => group.Count() > 1))
            yield return $"{string.Join(" and ", same)}: have the same name, {same.Key}";

        foreach (string finding in Materials(project, shaders))
            yield return finding;
    }

    private static IEnumerable<string> Of(ShaderFile shader)
    {
        string[] parts = [.. shader.Root.Parts.Select(part => part.Word)];
        if (!parts.SequenceEqual(["Properties", "SubShader", "Fallback"]))
        {
            yield return $"has {string.Join(", ", parts)}, not Properties, SubShader, Fallback";
            yield break;
        }

        ShaderPart sub = shader.Root.Parts[1];
        foreach (string tag in sub.Tags.Keys.Except(TagsOfSubShaders))
            yield return $"tag {tag} of the SubShader is not known here, or binds it to one pipeline";

        string common = string.Concat(sub.All("CGINCLUDE").Select(part => part.Program));
        foreach (ShaderPart property in shader.Root.Parts[0].Parts)
        {
            if (!property.Values.Any(Types.Contains))
                yield return $"line {property.Line}: {property.Word} is of no known type";

            if (!Regex.IsMatch(common, $@"\bfloat4 {property.Word};"))
                yield return $"property {property.Word} is not in the programs";
        }

        ShaderPart[] passes = [.. sub.All("Pass")];
        string?[] modes = [.. passes.Select(pass => pass.Tags.GetValueOrDefault("LightMode"))];
        if (!modes.SequenceEqual(Passes))
            yield return $"has passes {string.Join(", ", modes.Select(Named))}, not {string.Join(", ", Passes.Select(Named))}";

        foreach (string finding in passes.SelectMany(pass => OfPass(pass, common)))
            yield return finding;

        // what is drawn into the depth buffer must be found there again to the bit
        if (passes.Select(pass => Entry(Program(pass), "vertex")).Distinct().Count() > 1)
            yield return "its passes place a corner by different functions";
    }

    private static IEnumerable<string> OfPass(ShaderPart pass, string common)
    {
        foreach (string unknown in pass.Parts.Select(part => part.Word).Except(InPasses).Concat(pass.Tags.Keys.Except(TagsOfPasses)))
            yield return $"line {pass.Line}: {unknown} is not known here";

        foreach (ShaderPart mask in pass.All("ColorMask").Where(mask => !ColorMasks.Contains(string.Concat(mask.Values))))
            yield return $"line {mask.Line}: ColorMask {string.Concat(mask.Values)} is not known here";

        string program = common + Program(pass);
        if (!IsBalanced(program))
            yield return $"line {pass.Line}: parentheses or braces of the program are not balanced";

        foreach (string stage in new[] { "vertex", "fragment" })
        {
            if (Entry(program, stage) is not string entry)
                yield return $"line {pass.Line}: has no #pragma {stage}";
            else if (!Regex.IsMatch(program, $@"\b\w+ {entry}\("))
                yield return $"line {pass.Line}: there is no function {entry}";
        }

        foreach (string include in Include().Matches(program).Select(found => found.Groups[1].Value).Except(Includes))
            yield return $"line {pass.Line}: {include} is not in the projects of every pipeline";
    }

    private static IEnumerable<string> Materials(Project project, Dictionary<string, ShaderFile> shaders)
    {
        foreach ((string path, string text) in project.Files.Texts.Where(file => file.Key.EndsWith(".mat", StringComparison.Ordinal)))
        {
            // a material that is not as Unity writes it is another finding
            if (Saved(path, text) is not (string guid, string[] colors) || project.Asset(guid) is not string of || !shaders.TryGetValue(of, out ShaderFile? shader))
                continue;

            string[] properties = [.. shader.Root.All("Properties").SelectMany(block => block.Parts).Select(property => property.Word)];
            if (!properties.SequenceEqual(colors))
                yield return $"{path}: sets {string.Join(", ", colors)}, and its shader has {string.Join(", ", properties)}";
        }
    }

    private static (string Guid, string[] Colors)? Saved(string path, string text)
    {
        try
        {
            UnityObject material = UnityFile.Parse(path, text).Objects[0];
            IList<YamlNode> colors = material["m_SavedProperties"].Field("m_Colors").List();
            return (material["m_Shader"].Field("guid").Text(), [.. colors.SelectMany(color => ((YamlMappingNode)color).Children.Keys).Select(key => key.Text())]);
        }
        catch (Exception wrong) when (wrong is FormatException or InvalidCastException or ArgumentException)
        {
            return null;
        }
    }

    private static string Program(ShaderPart pass) => string.Concat(pass.All("CGPROGRAM").Select(part => part.Program));

    private static string? Entry(string program, string stage) => Regex.Match(program, $@"#pragma {stage} (\w+)") is { Success: true } found ? found.Groups[1].Value : null;

    private static string Named(string? mode) => mode ?? "without a LightMode";

    private static bool IsBalanced(string program)
    {
        Stack<char> open = new();
        foreach (char c in program)
        {
            if (c is '(' or '{' or '[')
                open.Push(c);
            else if (c is ')' or '}' or ']' && (open.Count == 0 || "(){}[]"["({[".IndexOf(open.Pop(), StringComparison.Ordinal) * 2 + 1] != c))
                return false;
        }

        return open.Count == 0;
    }

    [GeneratedRegex(@"#include ""([^""]*)""")]
    private static partial Regex Include();
}
