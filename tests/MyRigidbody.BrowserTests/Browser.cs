using System.Globalization;
using System.Text;
using System.Text.RegularExpressions;
using NUnit.Framework;
using OpenQA.Selenium;
using OpenQA.Selenium.Chrome;
using RigidBodyDynamics.Tests.Repository;

namespace RigidBodyDynamics.BrowserTests;

/// <summary>A Chromium without a window, which records every message of the console and every request.</summary>
internal sealed class Browser : IDisposable
{
    private static readonly TimeSpan Patience = TimeSpan.FromSeconds(20);

    private readonly ChromeDriverService _service;
    private readonly ChromeDriver _driver;
    private readonly List<string> _before = [];

    /// <summary>Starts one; the test is skipped where there is none.</summary>
    public Browser(params string[] arguments)
    {
        string? chromium = OnPath("chromium"), driver = OnPath("chromedriver");
        if (chromium == null || driver == null)
            Assert.Ignore("no chromium and chromedriver here (Debian: chromium, chromium-driver)");

        ChromeOptions options = new() { BinaryLocation = chromium };
        options.AddArguments("--headless=new", "--no-sandbox", "--disable-dev-shm-usage", "--hide-scrollbars", "--lang=en", "--window-size=1200,900");
        options.AddArguments(arguments);
        options.SetLoggingPreference(LogType.Browser, LogLevel.All);
        options.SetLoggingPreference("performance", LogLevel.All);
        _service = ChromeDriverService.CreateDefaultService(Path.GetDirectoryName(driver)!, Path.GetFileName(driver)!);
        _service.SuppressInitialDiagnosticInformation = true;
        try
        {
            _driver = new ChromeDriver(_service, options, Patience);
        }
        catch (Exception refused) when (refused.Message.Contains("session not created", StringComparison.OrdinalIgnoreCase))
        {
            // a chromedriver for another version of the browser; .ci/run counts what is skipped
            _service.Dispose();
            Assert.Ignore("chromedriver does not start this chromium: " + refused.Message.Split('\n')[0]);
            throw;
        }
    }

    /// <summary>Opens a page from the disk and waits until it is drawn.</summary>
    public void Open(string path, string hash = "") => OpenAddress(new Uri(path).AbsoluteUri + hash);

    /// <summary>Opens a page from a server and waits until an expression of JavaScript is true.</summary>
    public void Visit(string address, string ready, double? seconds = null)
    {
        // navigating to another fragment of the open address loads nothing
        _driver.Navigate().GoToUrl("about:blank");
        _driver.Navigate().GoToUrl(address);
        Assert.That(Becomes(ready, seconds), NUnit.Framework.Is.True, $"{address} is not ready: " + string.Join("; ", Complaints()));
    }

    /// <summary>Runs statements of JavaScript in every page that is opened, before it does anything itself.</summary>
    public void BeforeEachPage(string statements) => _before.Add((string)((Dictionary<string, object>)_driver.ExecuteCdpCommand(
        "Page.addScriptToEvaluateOnNewDocument", new Dictionary<string, object?> { ["source"] = statements })!)["identifier"]);

    /// <summary>Leaves the page, and resets what was set and recorded.</summary>
    public void Forget()
    {
        foreach (string script in _before)
            _driver.ExecuteCdpCommand("Page.removeScriptToEvaluateOnNewDocument", new Dictionary<string, object?> { ["identifier"] = script });

        _before.Clear();
        _driver.Navigate().GoToUrl("about:blank");
        Resize(1200, 900);
        Prefer("light");
        Complaints();
        Requests();
    }

    /// <summary>Files that the page saves go into a folder.</summary>
    public void SaveTo(string folder) => _driver.ExecuteCdpCommand(
        "Browser.setDownloadBehavior", new Dictionary<string, object?> { ["behavior"] = "allow", ["downloadPath"] = folder });

    /// <summary>Reloads the page from its present address.</summary>
    public void Reload() => OpenAddress("about:blank", _driver.Url);

    /// <summary>The value of a JavaScript expression.</summary>
    public T Get<T>(string expression, params object[] arguments) => (T)Convert.ChangeType(
        ((IJavaScriptExecutor)_driver).ExecuteScript($"return {expression}", arguments)!, typeof(T), CultureInfo.InvariantCulture);

    /// <summary>Runs a statement of JavaScript.</summary>
    public void Do(string statement) => ((IJavaScriptExecutor)_driver).ExecuteScript(statement);

    /// <summary>Waits until an expression of JavaScript is true.</summary>
    public bool Becomes(string expression, double? seconds = null)
    {
        DateTime until = DateTime.UtcNow + (seconds is double given ? TimeSpan.FromSeconds(given) : Patience);
        while (!Get<bool>($"Boolean({expression})"))
        {
            if (DateTime.UtcNow > until)
                return false;

            Thread.Sleep(50);
        }

        return true;
    }

    /// <summary>An element, by a selector of CSS.</summary>
    public IWebElement Find(string selector) => _driver.FindElement(By.CssSelector(selector));

    /// <summary>Presses keys where the focus is.</summary>
    public void Press(string keys) => new OpenQA.Selenium.Interactions.Actions(_driver).SendKeys(keys).Perform();

    /// <summary>Clicks at a place in an element, in pixels from its upper left corner.</summary>
    public void Click(string selector, int x, int y)
    {
        Do($"document.querySelector('{selector}').scrollIntoView()");
        IWebElement element = Find(selector);
        // from its middle, as the driver counts
        new OpenQA.Selenium.Interactions.Actions(_driver)
            .MoveToElement(element, x - element.Size.Width / 2, y - element.Size.Height / 2).Pause(TimeSpan.FromMilliseconds(300)).Click().Perform();
    }

    /// <summary>Draws with the pointer from the middle of an element.</summary>
    public void Drag(string selector, int x, int y) =>
        new OpenQA.Selenium.Interactions.Actions(_driver).MoveToElement(Find(selector)).ClickAndHold().MoveByOffset(x, y).Release().Perform();

    /// <summary>Makes the window as large as that of a device.</summary>
    public void Resize(int width, int height, bool isPhone = false) => _driver.ExecuteCdpCommand("Emulation.setDeviceMetricsOverride", new Dictionary<string, object?>
    {
        ["width"] = width,
        ["height"] = height,
        ["deviceScaleFactor"] = isPhone ? 2 : 1,
        ["mobile"] = isPhone,
    });

    /// <summary>Sets the system's colour scheme and its preference for reduced motion.</summary>
    public void Prefer(string scheme, string motion = "no-preference") => _driver.ExecuteCdpCommand("Emulation.setEmulatedMedia", new Dictionary<string, object?>
    {
        ["features"] = new object[]
        {
            new Dictionary<string, object> { ["name"] = "prefers-color-scheme", ["value"] = scheme },
            new Dictionary<string, object> { ["name"] = "prefers-reduced-motion", ["value"] = motion },
        },
    });

    /// <summary>The number of sheets of A4 that the page prints on.</summary>
    public int Sheets()
    {
        PrintOptions paper = new() { PageDimensions = PrintOptions.PageSize.A4 };
        return Regex.Count(Encoding.Latin1.GetString(_driver.Print(paper).AsByteArray), @"/Type\s*/Page\b");
    }

    /// <summary>The window and the whole page as pictures, into artifacts/screenshots.</summary>
    public void Photograph(string name)
    {
        string folder = Directory.CreateDirectory(Root.File("artifacts/screenshots")).FullName;
        foreach ((string ending, bool isWhole) in new[] { (".png", false), ("-whole.png", true) })
        {
            Dictionary<string, object> picture = (Dictionary<string, object>)_driver.ExecuteCdpCommand(
                "Page.captureScreenshot", new Dictionary<string, object?> { ["captureBeyondViewport"] = isWhole })!;
            File.WriteAllBytes(Path.Combine(folder, name + ending), Convert.FromBase64String((string)picture["data"]));
        }
    }

    /// <summary>Controls without a name for screen readers, as their roles.</summary>
    public string[] Unnamed()
    {
        string[] roles = ["button", "checkbox", "combobox", "slider", "spinbutton", "textbox", "link", "radio", "tab", "image", "img", "progressbar", "DisclosureTriangle"];
        object[] nodes = (object[])((Dictionary<string, object>)_driver.ExecuteCdpCommand("Accessibility.getFullAXTree", [])!)["nodes"];
        return [.. nodes.Cast<Dictionary<string, object>>()
            .Where(node => !(bool)node["ignored"] && roles.Contains(Value("role")(node)) && string.IsNullOrWhiteSpace(Value("name")(node)))
            .Select(node => Value("role")(node))];

        static Func<Dictionary<string, object>, string> Value(string name) => node =>
            node.TryGetValue(name, out object? found) && found is Dictionary<string, object> value && value.TryGetValue("value", out object? text) ? text as string ?? string.Empty : string.Empty;
    }

    /// <summary>Warnings and errors of the console.</summary>
    public string[] Complaints() =>
        [.. _driver.Manage().Logs.GetLog(LogType.Browser).Where(entry => entry.Level >= LogLevel.Warning).Select(entry => entry.Message)];

    /// <summary>Requested addresses, without the pages themselves and their embedded data.</summary>
    public string[] Requests() =>
        [.. _driver.Manage().Logs.GetLog("performance")
            .Select(entry => System.Text.Json.JsonDocument.Parse(entry.Message).RootElement.GetProperty("message"))
            .Where(message => message.GetProperty("method").GetString() is "Network.requestWillBeSent" or "Network.webSocketCreated")
            .Select(message => message.GetProperty("params"))
            .Select(about => about.TryGetProperty("request", out System.Text.Json.JsonElement request) ? request.GetProperty("url").GetString()! : about.GetProperty("url").GetString()!)
            .Where(address => !address.StartsWith("data:", StringComparison.Ordinal) && !address.StartsWith("blob:", StringComparison.Ordinal))];

    /// <inheritdoc/>
    public void Dispose()
    {
        _driver?.Quit();
        _service?.Dispose();
    }

    private void OpenAddress(params string[] addresses)
    {
        foreach (string address in addresses)
            _driver.Navigate().GoToUrl(address);

        Assert.That(Becomes("window.report && (report.cheapest || document.querySelector('.class, .student') || report.pictures && report.pictures() > 0)"), NUnit.Framework.Is.True, "the page draws nothing: " + string.Join("; ", Complaints()));
    }

    private static string? OnPath(string program) => (Environment.GetEnvironmentVariable("PATH") ?? string.Empty)
        .Split(Path.PathSeparator).Where(folder => folder.Length > 0).Select(folder => Path.Combine(folder, program)).FirstOrDefault(File.Exists);
}
