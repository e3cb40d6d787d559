using Microsoft.CodeAnalysis.CSharp;

namespace RigidBodyDynamics.StudentScripts.Compilation;

/// <summary>The language and the symbols with which an editor of Unity 2022.3 compiles.</summary>
internal static class Symbols
{
    public static CSharpParseOptions OfTheEditor { get; } = new(LanguageVersion.CSharp9, preprocessorSymbols: All());

    private static IEnumerable<string> All()
    {
        (int Year, int Minor)[] versions =
        [
            (2017, 1), (2017, 2), (2017, 3), (2017, 4), (2018, 1), (2018, 2), (2018, 3), (2018, 4), (2019, 1), (2019, 2), (2019, 3), (2019, 4),
            (2020, 1), (2020, 2), (2020, 3), (2021, 1), (2021, 2), (2021, 3), (2022, 1), (2022, 2), (2022, 3),
        ];
        return
        [
            "UNITY_EDITOR", "UNITY_EDITOR_64", "UNITY_EDITOR_WIN", "UNITY_STANDALONE", "UNITY_STANDALONE_WIN", "UNITY_64",
            "UNITY_2022", "UNITY_2022_3", "UNITY_5_3_OR_NEWER", "UNITY_5_4_OR_NEWER", "UNITY_5_5_OR_NEWER", "UNITY_5_6_OR_NEWER",
            .. versions.Select(version => $"UNITY_{version.Year}_{version.Minor}_OR_NEWER"),
            "ENABLE_MONO", "ENABLE_LEGACY_INPUT_MANAGER", "NET_STANDARD_2_0", "NET_STANDARD_2_1", "CSHARP_7_OR_LATER", "CSHARP_7_3_OR_NEWER",
            "DEBUG", "TRACE", "UNITY_ASSERTIONS",
        ];
    }
}
