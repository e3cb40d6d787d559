using System.Globalization;
using System.Reflection;
using System.Runtime.Loader;
using Microsoft.CodeAnalysis;

namespace RigidBodyDynamics.StudentScripts.Compilation;

/// <summary>What the compiler says in Chinese. Its translation is an assembly of its package, and a resource of ours.</summary>
internal static class CompilerInChinese
{
    private const string Culture = "zh-Hans", Resource = "compiler." + Culture;

    private static readonly CultureInfo Chinese = Found();

    /// <summary>The message of an error, without the stop at its end.</summary>
    public static string Message(Diagnostic error) => error.GetMessage(Chinese).TrimEnd('.', '。');

    private static CultureInfo Found()
    {
        // the runtime asks here for what is in no file, and without the system's cultures writes this one's name otherwise
        AssemblyLoadContext.Default.Resolving += (context, wanted) =>
            wanted.Name == "Microsoft.CodeAnalysis.CSharp.resources" && Culture.Equals(wanted.CultureName, StringComparison.OrdinalIgnoreCase) ? Load(context) : null;
        return CultureInfo.GetCultureInfo(Culture);
    }

    private static Assembly Load(AssemblyLoadContext context)
    {
        using Stream translation = typeof(CompilerInChinese).Assembly.GetManifestResourceStream(Resource)!;
        return context.LoadFromStream(translation);
    }
}
