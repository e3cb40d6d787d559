using System.Text;
using System.Text.RegularExpressions;
using RigidBodyDynamics.Lab.Output;

namespace RigidBodyDynamics.Lab.Package;

/// <summary>The files beside assets in which Unity stores their GUIDs.</summary>
internal static partial class Meta
{
    public static string GuidOf(string path, byte[] meta)
    {
        Match guid = Head().Match(Encoding.UTF8.GetString(meta));
        return guid.Success
            ? guid.Groups[1].Value
            : throw new InputException($"{path}: must begin with 'fileFormatVersion: 2' and 'guid: ' and 32 lower-case hex digits");
    }

    /// <summary>The meta of a folder, as Unity 2019.4 writes it.</summary>
    public static byte[] Folder(string guid) => Of(guid, "folderAsset: yes\nDefaultImporter:\n");

    /// <summary>The meta of a text.</summary>
    public static byte[] Text(string guid) => Of(guid, "TextScriptImporter:\n");

    // there is a space after an empty value
    private static byte[] Of(string guid, string importer) => Encoding.UTF8.GetBytes(
        $"fileFormatVersion: 2\nguid: {guid}\n{importer}  externalObjects: {{}}\n  userData: \n  assetBundleName: \n  assetBundleVariant: \n");

    [GeneratedRegex(@"\AfileFormatVersion: 2\nguid: ([0-9a-f]{32})\n")]
    private static partial Regex Head();
}
