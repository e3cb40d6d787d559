using System.CommandLine;
using System.Globalization;
using RigidBodyDynamics.Lab.Output;
using RigidBodyDynamics.Lab.Package;

namespace RigidBodyDynamics.Lab.Commands;

/// <summary>Writes the packages that students import into Unity.</summary>
internal static class PackCommand
{
    private const string Ending = ".unitypackage", DefaultFile = "MyRigidbody" + Ending, DefaultStarter = "MyRigidbody-Starter" + Ending;

    public static Command Create()
    {
        Option<bool> starter = new("--starter") { Description = "the package in which a student writes his own five steps" };
        Option<string?> output = new("--out") { Description = $"the package: {DefaultFile} or {DefaultStarter}", HelpName = "FILE" };
        Option<string?> list = new("--list") { Description = "only shows what is in a package", HelpName = "FILE" };
        Command command = new("pack", "The .unitypackage, from a checkout of the repository") { starter, output, list };
        command.SetAction(parsed => parsed.GetValue(list) is string packed ? List(packed) : Pack(parsed.GetValue(starter), parsed.GetValue(output)));
        return command;
    }

    private static int Pack(bool isStarter, string? output)
    {
        string path = output ?? (isStarter ? DefaultStarter : DefaultFile);
        // Unity's dialog shows no other files
        if (!path.EndsWith(Ending, StringComparison.Ordinal) || Path.GetFileName(path).Length == Ending.Length)
            throw new InputException($"--out: must be a file that ends in {Ending}, found \"{path}\"");

        IReadOnlyList<Asset> assets = isStarter ? Checkout.GatherStarter(Checkout.Root()) : Checkout.Gather(Checkout.Root());
        byte[] package = PackageWriter.Write(assets);
        using Files files = new(Path.GetDirectoryName(Path.GetFullPath(path))!, path, []);
        files.Write(Path.GetFileName(path), to => File.WriteAllBytes(to, package));
        files.Keep();
        Print(assets, package.Length);
        Terminal.WriteLine("written: " + path);
        return 0;
    }

    private static int List(string path)
    {
        IReadOnlyList<Asset> assets = PackageReader.Read(path);
        Print(assets, new FileInfo(path).Length);
        (string Path, string? Why)[] dangers = [.. assets.Select(asset => (asset.Path, AssetRules.Danger(asset.Path))).Where(danger => danger.Item2 != null)];
        return dangers.Length == 0
            ? 0
            : throw new FellShortException($"{path}: do not import it: \"{dangers[0].Path}\" {dangers[0].Why}" + (dangers.Length > 1 ? $", and {dangers.Length - 1} paths more are like that" : string.Empty));
    }

    private static void Print(IReadOnlyList<Asset> assets, long packed)
    {
        TextTable table = new TextTable("asset", "bytes").RightAligned();
        foreach (Asset asset in assets.OrderBy(asset => asset.Path, StringComparer.Ordinal))
            table.AddRow(asset.Path + (asset.IsFolder ? "/" : string.Empty), asset.Content is byte[] content ? Grouped(content.Length) : string.Empty);

        Terminal.Write(table);
        int files = assets.Count(asset => !asset.IsFolder);
        long bytes = assets.Sum(asset => asset.Content?.LongLength ?? 0);
        Terminal.WriteLine($"{files} files in {assets.Count - files} folders, {Grouped(bytes)} bytes; packed {Grouped(packed)} bytes");
    }

    private static string Grouped(long number) => number.ToString("N0", CultureInfo.InvariantCulture);
}
