using System;
using System.Collections.Generic;
using System.IO;
using System.Linq;
using Microsoft.CodeAnalysis;
using Microsoft.CodeAnalysis.CSharp;
using Microsoft.CodeAnalysis.Text;
using RigidBodyDynamics.Engine;

namespace UnityEditor.Compilation
{
    /// <summary>Compiles scripts into an assembly beside the project's own, and says so when it is done; here at once.</summary>
#if UNITY_2023_1_OR_NEWER
    [Obsolete("as in Unity since 2023.1, which names no other class")]
#endif
    public class AssemblyBuilder
    {
        private readonly string[] _scripts;

        public AssemblyBuilder(string assemblyPath, params string[] scriptPaths)
        {
            this.assemblyPath = assemblyPath;
            _scripts = scriptPaths;
        }

        public event Action<string, CompilerMessage[]> buildFinished;

        public string assemblyPath { get; }

        public string[] additionalReferences { get; set; } = new string[0];

        public bool Build()
        {
            string own = typeof(AssemblyBuilder).Assembly.Location;
            IEnumerable<string> references = ((string)AppContext.GetData("TRUSTED_PLATFORM_ASSEMBLIES")).Split(Path.PathSeparator)
                .Where(path => Path.GetFileName(path).StartsWith("System.", StringComparison.Ordinal) || Path.GetFileName(path) == "netstandard.dll").Append(own);
            CSharpCompilation compilation = CSharpCompilation.Create(
                Path.GetFileNameWithoutExtension(assemblyPath),
                _scripts.Select(path => CSharpSyntaxTree.ParseText(SourceText.From(File.ReadAllText(Of(path))), new CSharpParseOptions(LanguageVersion.CSharp9), path)),
                references.Select(path => MetadataReference.CreateFromFile(path)),
                new CSharpCompilationOptions(OutputKind.DynamicallyLinkedLibrary));
            CompilerMessage[] messages = compilation.Emit(assemblyPath).Diagnostics.Where(found => found.Severity == DiagnosticSeverity.Error)
                .Select(found => new CompilerMessage { message = found.ToString(), type = CompilerMessageType.Error, line = found.Location.GetLineSpan().StartLinePosition.Line + 1 }).ToArray();
            buildFinished?.Invoke(assemblyPath, messages);
            return true;
        }

        // a path of the project, or any other
        private static string Of(string path) => path.StartsWith("Assets/", StringComparison.Ordinal) ? SceneLoader.InProject(path) : path;
    }

    /// <summary>What the compiler says.</summary>
    public struct CompilerMessage
    {
        public string message;
        public string file;
        public int line;
        public int column;
        public CompilerMessageType type;
    }

    /// <summary>How bad it is.</summary>
    public enum CompilerMessageType
    {
        Error,
        Warning,
    }
}
