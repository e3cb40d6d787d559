using System.Diagnostics;
using System.Net;
using System.Net.Sockets;
using System.Text.RegularExpressions;
using NUnit.Framework;
using RigidBodyDynamics.Tests.CommandLine;

namespace RigidBodyDynamics.BrowserTests;

/// <summary>The program that builds and serves the lab in a browser.</summary>
public sealed partial class SiteServerTests
{
    private Process? _server;
    private HttpClient _client = null!;

    [OneTimeSetUp]
    public void Start()
    {
        _server = Process.Start(Program("--port", "0", "--no-browser"))!;
        string said = string.Empty;
        while (_server.StandardOutput.ReadLine() is string line && !Address().IsMatch(said = line))
        {
        }

        Assume.That(said, Does.Match(Address()));
        _client = new HttpClient { BaseAddress = new Uri(Address().Match(said).Value) };
    }

    [OneTimeTearDown]
    public void Stop()
    {
        _client?.Dispose();
        _server?.Kill();
        _server?.Dispose();
    }

    [TestCase("br, gzip", "br")]
    [TestCase("gzip, deflate", "gzip")]
    [TestCase("br;q=0, gzip", "gzip")]
    [TestCase("identity", null)]
    public async Task Text_is_sent_compressed_to_a_browser_that_accepts_it(string accepted, string? sent)
    {
        using HttpResponseMessage answer = await Get("app.js", accepted);

        Assert.That(answer.Content.Headers.ContentEncoding, Is.EqualTo(sent == null ? [] : new[] { sent }));
        Assert.That(answer.Content.Headers.ContentType!.MediaType, Is.EqualTo("text/javascript"));
    }

    [Test]
    public async Task Policy_of_the_page_comes_with_every_file()
    {
        foreach (string name in new[] { "", "app.js", "worker.js", "service-worker.js" })
        {
            using HttpResponseMessage answer = await Get(name, "gzip");
            string policy = answer.Headers.GetValues("Content-Security-Policy").Single();

            Assert.That(answer.StatusCode, Is.EqualTo(HttpStatusCode.OK));
            Assert.That(policy, Does.StartWith("default-src 'none';").And.Contain("connect-src 'self';"));
            Assert.That(File.ReadAllText(SiteFiles.InFolder("index.html")), Does.Contain(policy));
        }
    }

    [TestCase("nothing.js")]
    [TestCase("..%2f..%2fREADME.md")]
    [TestCase("write/")]
    public async Task Nothing_but_the_files_is_sent(string name)
    {
        using HttpResponseMessage answer = await Get(name, "gzip");

        Assert.That(answer.StatusCode, Is.EqualTo(HttpStatusCode.NotFound));
    }

    [Test]
    public void Port_that_another_has_is_refused()
    {
        using TcpListener other = new(IPAddress.Loopback, 0);
        other.Start();
        int port = ((IPEndPoint)other.LocalEndpoint).Port;

        Assert.That(Refusal(Program("--port", $"{port}", "--no-browser")), Does.StartWith($"error: port {port} of this machine cannot be used"));
    }

    [Test]
    public void Folder_that_cannot_be_written_is_refused()
    {
        using TemporaryFolder folder = new();
        string file = folder.File("a file");
        File.WriteAllText(file, "text");

        Assert.That(Refusal(Program("--out", file)), Does.StartWith($"error: {file}: cannot be written"));
        Assert.That(File.ReadAllText(file), Is.EqualTo("text"));
    }

    [Test]
    public void Missing_npm_is_named()
    {
        using TemporaryFolder empty = new();
        ProcessStartInfo start = Program("--out", empty.File("site"));
        start.FileName = Environment.GetEnvironmentVariable("PATH")!.Split(Path.PathSeparator).Select(folder => Path.Combine(folder, OperatingSystem.IsWindows() ? "dotnet.exe" : "dotnet")).First(File.Exists);
        start.Environment["PATH"] = empty.Path;

        Assert.That(Refusal(start), Does.StartWith("error: npm is not on the path"));
        Assert.That(Directory.GetFileSystemEntries(empty.Path), Is.Empty);
    }

    [Test]
    public void Option_that_it_does_not_know_is_refused() =>
        Assert.That(Refusal(Program("--prot", "80")), Does.StartWith("error: ").And.Contain("--prot").And.Contain("--help"));

    private async Task<HttpResponseMessage> Get(string name, string accepted)
    {
        using HttpRequestMessage request = new(HttpMethod.Get, name);
        request.Headers.Add("Accept-Encoding", accepted);
        return await _client.SendAsync(request);
    }

    // one line on standard error, and exit code 2
    private static string Refusal(ProcessStartInfo start)
    {
        using Process process = Process.Start(start)!;
        string error = process.StandardError.ReadToEnd();
        process.WaitForExit();
        Assert.That(process.ExitCode, Is.EqualTo(2));
        Assert.That(error.TrimEnd().Split('\n'), Has.Length.EqualTo(1));
        return error;
    }

    private static ProcessStartInfo Program(params string[] arguments)
    {
        // it builds the site where there is none, for minutes
        SiteFiles.Built("artifacts/site/index.html");
        string program = SiteFiles.Built("artifacts/bin/MyRigidbody.Web/release/MyRigidbody.Web.dll");
        return new ProcessStartInfo("dotnet", [program, .. arguments]) { RedirectStandardOutput = true, RedirectStandardError = true };
    }

    [GeneratedRegex("http://127\\.0\\.0\\.1:[0-9]+/")]
    private static partial Regex Address();
}
