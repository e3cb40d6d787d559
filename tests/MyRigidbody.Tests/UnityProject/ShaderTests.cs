using System.Diagnostics;
using System.Numerics;
using NUnit.Framework;
using RigidBodyDynamics.UnityFiles.Shading;

namespace RigidBodyDynamics.Tests.UnityProject;

/// <summary>The shader of the bodies: its programs are HLSL, and pictures in the documentation are shaded as it shades.</summary>
public sealed class ShaderTests
{
    // as Unity's manual describes what a shader may use of UnityCG.cginc
    private const string UnityCG = """
        float4x4 unity_ObjectToWorld, unity_WorldToObject, unity_MatrixVP;
        float4 UnityObjectToClipPos(float3 position) { return mul(unity_MatrixVP, mul(unity_ObjectToWorld, float4(position, 1))); }
        float3 UnityObjectToWorldNormal(float3 normal) { return normalize(mul(normal, (float3x3)unity_WorldToObject)); }
        """;

    private static readonly string Text = Change.Text(BrokenShaders.Shader);

    [Test]
    public void Both_packages_have_it_under_their_own_names() =>
        Assert.That(Change.Text(BrokenShaders.Starters), Is.EqualTo(Text.Replace("\"MyRigidbody/Matt\"", "\"MyRigidbodyStarter/Matt\"", StringComparison.Ordinal)));

    [Test]
    public void Pictures_are_shaded_by_its_formula_and_its_numbers()
    {
        MattShading shading = MattShading.Of(ShaderFile.Parse(Text));

        Assert.That(Text, Does.Contain("facing = 0.5 + 0.5 * dot(normalize(surface.normal), ToLight);"));
        Assert.That(Text, Does.Contain("shade = lerp(Darkest, Lightest, facing * facing);").And.Contain("return float4(_Color.rgb * shade, 1);"));
        Assert.That(shading.ToLight.Length(), Is.EqualTo(1).Within(1e-4));
        Assert.That(shading.At(-shading.ToLight), Is.EqualTo(0.38).Within(1e-6));
        Assert.That(shading.At(shading.ToLight), Is.EqualTo(1.12).Within(1e-3));
        // a quarter of the way from the far side's shade, where a surface is seen edge on
        Assert.That(shading.At(Vector3.Cross(shading.ToLight, Vector3.UnitX)), Is.EqualTo(0.38 + 0.74 / 4).Within(1e-3));
    }

    [TestCase("vert", "Place")]
    [TestCase("frag", "Shade")]
    [TestCase("frag", "ShowDepth")]
    [TestCase("frag", "ShowNormal")]
    public void Programs_are_HLSL(string stage, string entry)
    {
        string folder = Directory.CreateTempSubdirectory().FullName, program = Path.Combine(folder, "Matt.hlsl");
        try
        {
            File.WriteAllText(Path.Combine(folder, "UnityCG.cginc"), UnityCG);
            File.WriteAllText(program, ShaderFile.Parse(Text).Root.Parts[1].All("CGINCLUDE").Single().Program);
            foreach (string symbol in new[] { "UNITY_COLORSPACE_GAMMA", "LINEAR" })
                Assert.That(Compiled("-D", "-V", "-D" + symbol, "-I" + folder, "-S", stage, "-e", entry, "-o", Path.Combine(folder, "out.spv"), program), Does.Not.Contain("ERROR"));
        }
        finally
        {
            Directory.Delete(folder, recursive: true);
        }
    }

    private static string Compiled(params string[] arguments)
    {
        try
        {
            using Process glslang = Process.Start(new ProcessStartInfo("glslangValidator", arguments) { RedirectStandardOutput = true, RedirectStandardError = true })!;
            string said = glslang.StandardOutput.ReadToEnd() + glslang.StandardError.ReadToEnd();
            glslang.WaitForExit();
            return glslang.ExitCode == 0 ? said : "ERROR: " + said;
        }
        catch (System.ComponentModel.Win32Exception)
        {
            Assert.Ignore("glslangValidator is not installed");
            throw;
        }
    }
}
