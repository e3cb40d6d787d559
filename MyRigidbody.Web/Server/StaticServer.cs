using System.Diagnostics;
using System.Net;
using System.Net.Sockets;
using Microsoft.AspNetCore.Builder;
using Microsoft.AspNetCore.Hosting;
using Microsoft.AspNetCore.Hosting.Server;
using Microsoft.AspNetCore.Hosting.Server.Features;
using Microsoft.AspNetCore.Http;
using Microsoft.Extensions.DependencyInjection;
using Microsoft.Extensions.FileProviders;
using Microsoft.Extensions.Hosting;
using Microsoft.Extensions.Logging;

namespace RigidBodyDynamics.Web.Server;

/// <summary>Sends the files of the site to browsers of this machine, and nothing else.</summary>
internal static class StaticServer
{
    /// <summary>Refuses a port that another program uses.</summary>
    public static void MustBeFree(int port)
    {
        try
        {
            using TcpListener probe = new(IPAddress.Loopback, port);
            probe.Start();
        }
        catch (SocketException taken)
        {
            throw new RefusedException($"port {port} of this machine cannot be used: {taken.Message}. --port 0 takes any that is free.");
        }
    }

    /// <summary>Serves until it is stopped.</summary>
    public static async Task Run(string folder, int port, bool openBrowser, CancellationToken stop)
    {
        WebApplicationBuilder builder = WebApplication.CreateSlimBuilder();
        builder.Logging.ClearProviders();
        builder.WebHost.ConfigureKestrel(kestrel => kestrel.Listen(IPAddress.Loopback, port));
        await using WebApplication server = builder.Build();
        using PhysicalFileProvider files = new(folder);
        server.Use((context, next) =>
        {
            IHeaderDictionary headers = context.Response.Headers;
            headers.ContentSecurityPolicy = Policy.Of(folder);
            headers.XContentTypeOptions = "nosniff";
            headers["Referrer-Policy"] = "no-referrer";
            headers["Cross-Origin-Opener-Policy"] = "same-origin";
            headers["Cross-Origin-Embedder-Policy"] = "require-corp";
            headers.CacheControl = "no-cache";
            return next(context);
        });
        server.UseSite(files);
        MustBeFree(port);
        await server.StartAsync(stop);
        string address = server.Services.GetRequiredService<IServer>().Features.Get<IServerAddressesFeature>()!.Addresses.First() + "/";
        Console.WriteLine($"the lab is at {address} (Ctrl+C ends it)");
        if (openBrowser)
            OpenBrowser(address);

        await server.WaitForShutdownAsync(stop);
    }

    // a machine without a desktop is no error
    private static void OpenBrowser(string address)
    {
        try
        {
            if (OperatingSystem.IsWindows())
                Process.Start(new ProcessStartInfo(address) { UseShellExecute = true })?.Dispose();
            else if (OperatingSystem.IsMacOS())
                Process.Start("open", address).Dispose();
            else if (Environment.GetEnvironmentVariable("DISPLAY") is { Length: > 0 } || Environment.GetEnvironmentVariable("WAYLAND_DISPLAY") is { Length: > 0 })
                Process.Start("xdg-open", address).Dispose();
        }
        catch (System.ComponentModel.Win32Exception)
        {
        }
    }
}
