using NUnit.Framework;
using static RigidBodyDynamics.Tests.UnityProject.Change;

namespace RigidBodyDynamics.Tests.UnityProject;

/// <summary>Shaders that one of the pipelines would not draw, or no editor compile.</summary>
internal static class BrokenShaders
{
    public const string Shader = Assets + "Materials/Matt.shader", Starters = "UnityProject/Assets/MyRigidbodyStarter/Materials/Matt.shader";

    public static IEnumerable<TestCaseData> All() =>
    [
        Found("a brace less", Replace(Shader, "SubShader\n    {", "SubShader\n"), "Matt.shader: line"),
        Found("a brace more", Replace(Shader, "    Fallback Off\n", "    Fallback Off\n}\n"), "Matt.shader: line"),
        Found("a program without an end", Replace(Shader, "            #pragma fragment ShowNormal\n            ENDCG", "#pragma fragment ShowNormal"), "no ENDCG"),
        Found("a parenthesis less in a program", Replace(Shader, "normalize(surface.normal)", "normalize(surface.normal"), "are not balanced"),
        Found("a shader for one pipeline", Replace(Shader, "\"Queue\" =", "\"RenderPipeline\" ="), "tag RenderPipeline"),
        Found("a colour pass that waits for lights", Replace(Shader, "Name \"Colour\"", "Tags { \"LightMode\" = \"ForwardBase\" }"), "has passes ForwardBase, DepthOnly"),
        Found("no pass for the depth", Replace(Shader, "\"LightMode\" = \"DepthOnly\"", "\"LightMode\" = \"Depth\""), "not without a LightMode, DepthOnly, DepthNormals"),
        Found("a command that is misspelt", Replace(Shader, "ColorMask R", "ColourMask R"), "ColourMask is not known"),
        Found("an include of URP", Replace(Shader, "UnityCG.cginc", "Packages/com.unity.render-pipelines.universal/ShaderLibrary/Core.hlsl"), "is not in the projects of every pipeline"),
        Found("a function that is not there", Replace(Shader, "#pragma fragment Shade\n", "#pragma fragment Shadow\n"), "there is no function Shadow"),
        Found("no vertex function", Replace(Shader, "#pragma vertex Place\n", ""), "has no #pragma vertex"),
        Found("a depth from elsewhere", Replace(Shader, "#pragma vertex Place\n", "#pragma vertex Shade\n"), "by different functions"),
        Found("a property that no program reads", Replace(Shader, "float4 _Color;", "float4 _Colour;"), "property _Color is not in the programs"),
        Found("a property of a type unknown here", Replace(Shader, "\"Colour\", Color)", "\"Colour\", 2D)"), "is of no known type"),
        Found("a shader's name twice", Real.With(Starters, Text(Shader)), "have the same name, MyRigidbody/Matt"),
        Found("a material with a colour that the shader has not", Replace(Assets + "Materials/Blue.mat", "    - _Color:", "    - _Tint:"), "sets _Tint, and its shader has _Color"),
    ];
}
