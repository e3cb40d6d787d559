using System.Runtime.InteropServices;

namespace RigidBodyDynamics.Lab.Languages;

/// <summary>The language of the system; numbers and sorting do not depend on it.</summary>
internal static class Locale
{
    // the primary language of a Windows language number
    private const int Primary = 0x3FF, Chinese = 4;

    public static bool IsChinese => OperatingSystem.IsWindows()
        ? (GetUserDefaultUILanguage() & Primary) == Chinese
        : new[] { "LC_ALL", "LC_MESSAGES", "LANG" }.Select(Environment.GetEnvironmentVariable).FirstOrDefault(value => !string.IsNullOrEmpty(value))?
            .StartsWith("zh", StringComparison.OrdinalIgnoreCase) == true;

    [DllImport("kernel32.dll")]
    private static extern ushort GetUserDefaultUILanguage();
}
