using System.Runtime.CompilerServices;
using Microsoft.CodeAnalysis;
using Microsoft.CodeAnalysis.CSharp;
using Microsoft.CodeAnalysis.CSharp.Syntax;

namespace RigidBodyDynamics.UnityFiles.Checks;

/// <summary>The components among the project's sources, as Unity 2019.4 finds them: by the name of the file.</summary>
internal sealed class Scripts
{
    private static readonly CSharpParseOptions Unity2019 = new(
        LanguageVersion.CSharp7_3, preprocessorSymbols: ["UNITY_EDITOR", "UNITY_2019_3_OR_NEWER", "UNITY_2019_4_OR_NEWER", "ENABLE_LEGACY_INPUT_MANAGER"]);

    // copies of a project share the texts in which they do not differ, and parsing them takes most of the time of a check
    private static readonly ConditionalWeakTable<string, SyntaxNode[]> Declared = [];

    private readonly Dictionary<string, Script> _byFile = [];
    private readonly Dictionary<string, int> _enums = [];

    public Scripts(ProjectFiles files)
    {
        foreach ((string path, string text) in files.Texts.Where(file => file.Key.EndsWith(".cs", StringComparison.Ordinal)))
        {
            SyntaxNode[] types = Declared.GetValue(text, TypesIn);
            foreach (EnumDeclarationSyntax found in types.OfType<EnumDeclarationSyntax>())
                _enums.TryAdd(found.Identifier.Text, found.Members.Count);

            foreach (Script script in types.OfType<ClassDeclarationSyntax>().Where(Script.IsComponent).Select(type => new Script(type)))
            {
                if (script.Name == Path.GetFileNameWithoutExtension(path))
                    _byFile.Add(path, script);
                else
                    Misnamed.Add($"{path}: class {script.Name} is a component, and Unity 2019.4 finds those by the name of the file");
            }
        }
    }

    /// <summary>Components that are not called like their file.</summary>
    public List<string> Misnamed { get; } = [];

    /// <summary>The component in a file; null if there is none.</summary>
    public Script? In(string path) => _byFile.GetValueOrDefault(path);

    // there are none in members
    private static SyntaxNode[] TypesIn(string source) => [.. CSharpSyntaxTree.ParseText(source, Unity2019).GetCompilationUnitRoot()
        .DescendantNodes(node => node is CompilationUnitSyntax or NamespaceDeclarationSyntax or TypeDeclarationSyntax)
        .Where(node => node is EnumDeclarationSyntax or ClassDeclarationSyntax)];

    /// <summary>How a field of a type is written, as in Layouts.yaml; null if the type is not known here.</summary>
    public string? KindOf(string type) => type switch
    {
        "bool" => "bool",
        "int" => "int",
        "float" or "double" => "float",
        "string" => "text",
        "Vector3" => "vector3",
        "Quaternion" => "rotation",
        "Color" => "color",
        "RigidbodyConstraints" => "one of 127",
        "RigidbodyInterpolation" => "one of 3",
        _ when _enums.TryGetValue(type, out int names) => $"one of {names}",
        _ when _byFile.Values.Any(script => script.Name == type) => $"-> {type} or none",
        _ => null,
    };
}

/// <summary>A component's class: what it is called, what its object must have, what is saved of it.</summary>
internal sealed class Script
{
    public Script(ClassDeclarationSyntax type)
    {
        Name = type.Identifier.Text;
        IEnumerable<AttributeSyntax> attributes = type.AttributeLists.SelectMany(list => list.Attributes).ToList();
        IsAlone = attributes.Any(attribute => attribute.Name.ToString() == "DisallowMultipleComponent");
        Needs = [.. attributes.Where(attribute => attribute.Name.ToString() == "RequireComponent")
            .SelectMany(attribute => attribute.DescendantNodes().OfType<TypeOfExpressionSyntax>()).Select(found => found.Type.ToString())];
        Fields = [.. type.Members.OfType<FieldDeclarationSyntax>().Where(IsSaved)
            .SelectMany(field => field.Declaration.Variables.Select(name => (name.Identifier.Text, field.Declaration.Type.ToString())))];
    }

    /// <summary>The class.</summary>
    public string Name { get; }

    /// <summary>True if an object may have one of it only.</summary>
    public bool IsAlone { get; }

    /// <summary>Components that its object must have.</summary>
    public string[] Needs { get; }

    /// <summary>The fields that Unity saves, in the order of the source.</summary>
    public (string Name, string Type)[] Fields { get; }

    /// <summary>True for a class of its own that can be put on an object.</summary>
    public static bool IsComponent(ClassDeclarationSyntax type) =>
        type.Parent is not ClassDeclarationSyntax && type.BaseList?.Types.Any(found => found.Type.ToString() is "MonoBehaviour" or "UnityEngine.MonoBehaviour") == true;

    // public, or told to be saved; never what is static, constant or read only
    private static bool IsSaved(FieldDeclarationSyntax field)
    {
        bool Has(SyntaxKind modifier) => field.Modifiers.Any(found => found.IsKind(modifier));
        bool Is(string attribute) => field.AttributeLists.SelectMany(list => list.Attributes).Any(found => found.Name.ToString() == attribute);
        return (Has(SyntaxKind.PublicKeyword) || Is("SerializeField")) && !Is("NonSerialized") && !Is("System.NonSerialized")
            && !Has(SyntaxKind.StaticKeyword) && !Has(SyntaxKind.ConstKeyword) && !Has(SyntaxKind.ReadOnlyKeyword);
    }
}
