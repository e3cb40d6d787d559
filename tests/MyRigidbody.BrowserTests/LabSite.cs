using System.Collections.Concurrent;
using System.Net;
using System.Net.Sockets;

namespace RigidBodyDynamics.BrowserTests;

/// <summary>The built lab in a browser on a plain server: it knows names and types of files, compresses nothing and adds no header.</summary>
internal sealed class LabSite : IDisposable
{
    private static readonly Dictionary<string, string> Types = new()
    {
        [".html"] = "text/html; charset=utf-8",
        [".js"] = "text/javascript",
        [".css"] = "text/css",
        [".json"] = "application/json",
        [".txt"] = "text/plain; charset=utf-8",
        [".webmanifest"] = "application/manifest+json",
        [".svg"] = "image/svg+xml",
        [".png"] = "image/png",
    };

    private readonly string _folder;
    private readonly ConcurrentQueue<(string Path, long Bytes)> _sent = new();
    private HttpListener _listener = null!;

    /// <summary>Serves it at once; the test is skipped where it has not been built.</summary>
    /// <param name="folder">A folder of the test's own, in place of the built one.</param>
    public LabSite(string? folder = null)
    {
        _folder = folder ?? SiteFiles.Folder;
        using (TcpListener free = new(IPAddress.Loopback, 0))
        {
            free.Start();
            Address = $"http://127.0.0.1:{((IPEndPoint)free.LocalEndpoint).Port}/";
        }

        Start();
    }

    /// <summary>Of the page.</summary>
    public string Address { get; }

    /// <summary>The requests, and the number of bytes sent for each, in order.</summary>
    public (string Path, long Bytes)[] Sent => [.. _sent];

    /// <summary>Serves it, at the same address as before.</summary>
    public void Start()
    {
        HttpListener listener = _listener = new HttpListener();
        listener.Prefixes.Add(Address);
        listener.Start();
        new Thread(() => Serve(listener)) { IsBackground = true }.Start();
    }

    /// <summary>The server no longer answers.</summary>
    public void Stop() => _listener.Close();

    /// <inheritdoc/>
    public void Dispose() => Stop();

    private void Serve(HttpListener listener)
    {
        while (true)
        {
            HttpListenerContext asked;
            try
            {
                asked = listener.GetContext();
            }
            catch (Exception over) when (over is HttpListenerException or ObjectDisposedException or InvalidOperationException)
            {
                return;
            }

            ThreadPool.QueueUserWorkItem(_ => Answer(asked));
        }
    }

    private void Answer(HttpListenerContext asked)
    {
        string path = Uri.UnescapeDataString(asked.Request.Url!.AbsolutePath).TrimStart('/');
        string file = Path.Combine(_folder, path.Length == 0 || path.EndsWith('/') ? path + "index.html" : path);
        try
        {
            using HttpListenerResponse answer = asked.Response;
            if (!File.Exists(file))
            {
                answer.StatusCode = 404;
                _sent.Enqueue((path, 0));
                return;
            }

            byte[] bytes = File.ReadAllBytes(file);
            answer.ContentType = Types.GetValueOrDefault(Path.GetExtension(file), "application/octet-stream");
            answer.ContentLength64 = bytes.Length;
            _sent.Enqueue((path, bytes.Length));
            answer.OutputStream.Write(bytes);
        }
        catch (Exception gone) when (gone is HttpListenerException or IOException or ObjectDisposedException)
        {
            // the page went away, or the server was stopped
        }
    }
}
