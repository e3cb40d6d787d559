using Microsoft.AspNetCore.Builder;
using Microsoft.AspNetCore.Http;
using Microsoft.AspNetCore.StaticFiles;
using Microsoft.Extensions.FileProviders;
using Microsoft.Net.Http.Headers;

namespace RigidBodyDynamics.Web.Server;

/// <summary>Sends the compressed copy of a file to a browser that accepts it.</summary>
internal static class Packed
{
    private static readonly FileExtensionContentTypeProvider Types = new();

    private static readonly (string Encoding, string Ending)[] Encodings = [("br", ".br"), ("gzip", ".gz")];

    /// <summary>The files of the site.</summary>
    public static void UseSite(this IApplicationBuilder server, IFileProvider files)
    {
        server.UseDefaultFiles(new DefaultFilesOptions { FileProvider = files });
        server.Use((context, next) =>
        {
            string path = context.Request.Path;
            foreach ((string encoding, string ending) in Encodings)
            {
                if (Accepts(context.Request, encoding) && files.GetFileInfo(path + ending).Exists)
                {
                    context.Request.Path = path + ending;
                    context.Response.Headers.ContentEncoding = encoding;
                    break;
                }
            }

            return next(context);
        });
        server.UseStaticFiles(new StaticFileOptions { FileProvider = files, ServeUnknownFileTypes = true, OnPrepareResponse = Describe });
    }

    private static bool Accepts(HttpRequest request, string encoding) =>
        request.GetTypedHeaders().AcceptEncoding.Any(accepted => accepted.Value == encoding && accepted.Quality != 0);

    // the type is that of the plain file
    private static void Describe(StaticFileResponseContext sent)
    {
        string name = sent.File.Name;
        if (sent.Context.Response.Headers.ContentEncoding.Count > 0)
            name = Path.GetFileNameWithoutExtension(name);

        sent.Context.Response.Headers.Vary = HeaderNames.AcceptEncoding;
        sent.Context.Response.ContentType = Types.TryGetContentType(name, out string? type)
            ? type.StartsWith("text/", StringComparison.Ordinal) ? type + "; charset=utf-8" : type
            : "application/octet-stream";
    }
}
