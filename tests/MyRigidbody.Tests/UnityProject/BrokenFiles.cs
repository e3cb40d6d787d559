using NUnit.Framework;
using RigidBodyDynamics.UnityFiles.Checks;
using static RigidBodyDynamics.Tests.UnityProject.Change;

namespace RigidBodyDynamics.Tests.UnityProject;

/// <summary>Metas, assembly definitions, settings and packages that an editor would complain about, or silently put right.</summary>
internal static class BrokenFiles
{
    private const string Meta = Sources + "Panel.cs.meta", Manifest = "UnityProject/Packages/manifest.json", Package = "MyRigidbody.Core/package.json";
    private const string ScriptsAssembly = Sources + "MyRigidbody.Scripts.asmdef", InputAssembly = Assets + "InputSystem/MyRigidbody.InputSystem.asmdef", BuildSettings = Settings + "EditorBuildSettings.asset";

    public static IEnumerable<TestCaseData> All() => [.. Metas(), .. MadeUp(), .. Assemblies(), .. ProjectSettings(), .. Packages()];

    private static IEnumerable<TestCaseData> Metas() =>
    [
        Found("a missing meta", Real.Without(Meta), "Panel.cs: has no meta"),
        Found("a missing meta of a folder", Real.Without(Assets + "Scenes.meta"), "MyRigidbody/Scenes: has no meta"),
        Found("an orphan meta", Real.With(Sources + "Gone.cs.meta", Text(Meta)), "Gone.cs.meta: nothing stands beside it"),
        Found("a GUID used twice", Real.With(Meta, Text(Sources + "Yardstick.cs.meta")), "has the GUID of"),
        Found("a GUID of an asset of the Core", Real.With(Meta, Text("MyRigidbody.Core/Scenes/Body.cs.meta")), "has the GUID of"),
        Found("a GUID in capital letters", With(Guid(Sources + "Panel.cs").ToUpperInvariant()), "32 lower-case hex digits"),
        Found("a GUID with dashes", With("8-" + Guid(Sources + "Panel.cs")[2..]), "32 lower-case hex digits"),
        Found("an empty line in a meta", Real.With(Meta, Text(Meta) + "\n"), "is not as Unity 2019.4 writes it"),
        Found("the meta of another importer", Replace(Meta, "MonoImporter", "DefaultImporter"), "is not as Unity 2019.4 writes it"),
        Found(
            "a material without its main object",
            Replace(Assets + "Materials/Blue.mat.meta", "  mainObjectFileID: 2100000\n", ""),
            "is not as Unity 2019.4 writes it"),
        Found("a folder that is not said to be one", Replace(Assets + "Scenes.meta", "folderAsset: yes\n", ""), "is not as Unity 2019.4 writes it"),
    ];

    private static IEnumerable<TestCaseData> MadeUp() =>
    [
        Found("a GUID of few digits", With("00000000000000001234560000000000"), "is not random"),
        Found("a GUID that counts", With("5f0e9a0123456789abcdef02c4d7b1e3"), "is not random"),
        Found("a GUID that counts down", With("4b7ed1fedcba98360a52c97143fd07e8"), "is not random"),
        Found("a GUID of letters and numbers in turn", With("a1b2c3d4e5f6a7b8c9d0e1f2a3b4c5d6"), "is not random"),
    ];

    private static IEnumerable<TestCaseData> Assemblies() =>
    [
        Found(
            "an assembly that is not there",
            Replace(ScriptsAssembly, "\"MyRigidbody.Core\"", "\"MyRigidbody.Kern\""),
            "refers to MyRigidbody.Kern, which is no assembly here"),
        Found("an assembly's name twice", Real.With(Assets + "Editor/MyRigidbody.Editor.asmdef", Text(ScriptsAssembly)), "has the name of"),
        Found(
            "an assembly called unlike its file",
            Replace(ScriptsAssembly, "\"name\": \"MyRigidbody.Scripts\"", "\"name\": \"Scripts\""),
            "is called Scripts, unlike its file"),
        Found("a field of 2020 in an assembly", Replace(ScriptsAssembly, "{\n", "{\n  \"rootNamespace\": \"\",\n"), "rootNamespace is not known to Unity 2019.4"),
        Found(
            "platforms both in and out",
            Replace(Assets + "Editor/MyRigidbody.Editor.asmdef", "\"excludePlatforms\": []", "\"excludePlatforms\": [\"WSA\"]"),
            "includes and excludes platforms"),
        Found(
            "an assembly that needs a package which may be missing",
            Replace(InputAssembly, ", \"MYRIGIDBODY_HAS_INPUT_SYSTEM\"", ""),
            "is not left out where com.unity.inputsystem is missing"),
        Found(
            "an assembly that is left out for another package's sake",
            Replace(InputAssembly, "\"com.unity.inputsystem\"", "\"com.unity.input\""),
            "is not left out where com.unity.inputsystem is missing"),
        Found("an assembly that is no JSON", Real.With(ScriptsAssembly, "{"), "is not a JSON object with a name"),
        Found("a script in no assembly", Real.With(Assets + "Loose.cs", ""), "Loose.cs: is in no assembly of ours"),
    ];

    private static IEnumerable<TestCaseData> ProjectSettings() =>
    [
        Found("another step", Replace(Settings + "TimeManager.asset", "Fixed Timestep: 0.02", "Fixed Timestep: 0.0167"), "Fixed Timestep: 0.0167 is not =0.02"),
        Found("binary files", Replace(Settings + "EditorSettings.asset", "m_SerializationMode: 2", "m_SerializationMode: 1"), "m_SerializationMode"),
        Found(
            "the word misspelt, as before 2019.3",
            Replace(Settings + "DynamicsManager.asset", "AngularSpeed", "AngluarSpeed"),
            "lacks m_DefaultMaxAngularSpeed"),
        Found("the physics of 2018", Replace(Settings + "DynamicsManager.asset", "serializedVersion: 13", "serializedVersion: 11"), "serializedVersion: 11 is not =13"),
        Found("missing settings", Real.Without(Settings + "TimeManager.asset"), "TimeManager.asset: is missing"),
        Found("the editor of mainland China", Replace(Settings + "ProjectVersion.txt", "f1\n", "f1c1\n"), "must have the two lines of 2019.4.17f1"),
        Found("a scene that is not there", Replace(BuildSettings, "Lab.unity", "Labor.unity"), "lists Assets/MyRigidbody/Scenes/Labor.unity, which is not there"),
        Found("a scene that is not listed", Replace(BuildSettings, "Lab.unity", "Labor.unity"), $"does not list {LabScene}"),
        Found("a scene by another GUID", Replace(BuildSettings, Guid(LabScene), Guid(SlabScene)), "has another GUID"),
    ];

    private static IEnumerable<TestCaseData> Packages() =>
    [
        Found("a package that is not there", Replace(Manifest, "file:../../", "file:../"), "there is no package at ../MyRigidbody.Core"),
        Found("a package of another name", Replace(Package, "org.myrigidbody.core", "org.myrigidbody.kern"), "is called org.myrigidbody.kern"),
        Found("a package for a whole version", Replace(Package, "\"unity\": \"2019.4\"", "\"unity\": \"2019.4.17f1\""), "must say \"unity\": \"2019.4\""),
        Found("a version that is none", Replace(Manifest, "1.1.33", "latest"), "latest is not a version"),
        Found("no physics", Replace(Manifest, "    \"com.unity.modules.physics\": \"1.0.0\",\n", ""), "lacks com.unity.modules.physics"),
        Found("a manifest that is no JSON", Real.With(Manifest, "{"), "is not a JSON object with dependencies"),
    ];

    private static ProjectFiles With(string guid) => Replace(Meta, Guid(Sources + "Panel.cs"), guid);
}
