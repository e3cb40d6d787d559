using System.Reflection;
using System.Runtime.Loader;
using System.Security;
using NUnit;
using NUnit.Framework.Api;
using NUnit.Framework.Interfaces;
using NUnit.Framework.Internal;

namespace RigidBodyDynamics.Mutants;

/// <summary>
/// The tests with one Core, in this process. Core, tests and command line are loaded anew for every Core, so that no table
/// made under one mutant is there under the next; everything else is loaded once.
/// </summary>
internal sealed class TestBench : IDisposable
{
    private static readonly string[] Anew = ["MyRigidbody.Tests", "MyRigidbody.Lab"];
    private readonly AssemblyLoadContext _context = new("mutant", isCollectible: true);
    private readonly Assembly _tests;

    public TestBench(byte[] core, string testFolder)
    {
        Core = _context.LoadFromStream(new MemoryStream(core));
        _context.Resolving += (context, name) =>
            name.Name == Core.GetName().Name ? Core
            : Anew.Contains(name.Name) ? context.LoadFromAssemblyPath(Path.Combine(testFolder, name.Name + ".dll")) : null;
        _tests = _context.LoadFromAssemblyPath(Path.Combine(testFolder, Anew[0] + ".dll"));
    }

    /// <summary>The Core under test.</summary>
    public Assembly Core { get; }

    /// <summary>Makes this process one in which the tests find what they find in their own folder.</summary>
    public static void Furnish(string testFolder)
    {
        AppContext.SetData("APP_CONTEXT_BASE_DIRECTORY", testFolder + Path.DirectorySeparatorChar);
        AssemblyLoadContext.Default.Resolving += (context, name) =>
        {
            string path = Path.Combine(testFolder, name.Name + ".dll");
            return !Anew.Contains(name.Name) && name.Name != "MyRigidbody.Core" && File.Exists(path) ? context.LoadFromAssemblyPath(path) : null;
        };
    }

    /// <summary>The fixtures of the tests.</summary>
    public IEnumerable<Type> Fixtures => _tests.GetTypes()
        .Where(type => type.IsPublic && type.GetMethods().Any(method => method.GetCustomAttributes().Any(found => found is ITestBuilder or ISimpleTestBuilder)));

    /// <summary>Lists the cases of some fixtures.</summary>
    public NUnitTestAssemblyRunner List(IEnumerable<string> fixtures, bool toFirstFailure)
    {
        NUnitTestAssemblyRunner runner = new(new DefaultTestAssemblyBuilder());
        runner.Load(_tests, new Dictionary<string, object>
        {
            [FrameworkPackageSettings.NumberOfTestWorkers] = 0,
            [FrameworkPackageSettings.StopOnError] = toFirstFailure,
            [FrameworkPackageSettings.LOAD] = fixtures.ToList(),
        });
        return runner;
    }

    /// <summary>Runs all cases listed.</summary>
    public static void Run(NUnitTestAssemblyRunner runner, Action<ITestResult> finished) =>
        runner.Run(new Listener(finished), TestFilter.Empty);

    /// <summary>Runs some tests to the first that fails, and gives its name.</summary>
    public string? FirstFailure(IEnumerable<string> fixtures, IEnumerable<string> tests)
    {
        string? failed = null;
        IEnumerable<string> names = tests.Select(test => "<test>" + SecurityElement.Escape(test) + "</test>");
        TestFilter filter = TestFilter.FromXml("<filter><or>" + string.Concat(names) + "</or></filter>");
        List(fixtures, toFirstFailure: true).Run(
            new Listener(result => failed ??= result.ResultState.Status == TestStatus.Failed ? result.FullName : null), filter);
        return failed;
    }

    public void Dispose() => _context.Unload();

    private sealed class Listener(Action<ITestResult> finished) : ITestListener
    {
        public void TestStarted(ITest test) { }

        public void TestFinished(ITestResult result)
        {
            if (!result.Test.HasChildren)
                finished(result);
        }

        public void TestOutput(TestOutput output) { }

        public void SendMessage(TestMessage message) { }
    }
}
