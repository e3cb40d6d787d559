using System.Globalization;
using System.Xml;
using System.Xml.Linq;
using RigidBodyDynamics.Lab.Output;

namespace RigidBodyDynamics.Lab.Inertia.Robots;

/// <summary>Reads a robot description in XML. Nothing it refers to is fetched, entities are not expanded, and its depth is limited.</summary>
internal static class XmlFile
{
    private const int MostDepth = 200, MostNodes = 1_000_000, MostCharacters = 1 << 26;

    /// <summary>The root of the file.</summary>
    public static XElement Read(string path)
    {
        ArraySegment<byte> bytes = InputFile.Bytes(path);
        try
        {
            // first without a tree, only for its limits, because a tree takes many times the memory
            using (XmlReader limits = Reader(bytes))
            {
                for (int nodes = 0; limits.Read(); nodes += 1 + limits.AttributeCount)
                {
                    if (limits.Depth > MostDepth || nodes > MostNodes)
                        throw Wrong(path, (IXmlLineInfo)limits, limits.Depth > MostDepth ? $"elements go deeper than {MostDepth}" : $"has more than {MostNodes} elements and attributes");
                }
            }

            using XmlReader reader = Reader(bytes);
            return XDocument.Load(reader, LoadOptions.SetLineInfo).Root ?? throw new InputException($"{path}: has no element");
        }
        catch (XmlException broken)
        {
            string what = broken.Message.Contains("DTD", StringComparison.Ordinal)
                ? "has a DOCTYPE, which is not read: what it defines could grow without end"
                : broken.Message.Contains("MaxCharactersInDocument", StringComparison.Ordinal) ? $"has more than {MostCharacters >> 20} million characters" : broken.Message.ReplaceLineEndings(" ").Split(" Line ")[0];
            throw new InputException(broken.LineNumber > 0 ? string.Create(CultureInfo.InvariantCulture, $"{path}: line {broken.LineNumber}: {what}") : $"{path}: {what}");
        }
    }

    /// <summary>The line of an element: "line 12".</summary>
    public static string Line(IXmlLineInfo element) => string.Create(CultureInfo.InvariantCulture, $"line {element.LineNumber}");

    /// <summary>The error at an element.</summary>
    public static InputException Wrong(string path, IXmlLineInfo element, string what) => new($"{path}: {Line(element)}: {what}");

    private static XmlReader Reader(ArraySegment<byte> bytes) => XmlReader.Create(
        new MemoryStream(bytes.Array!, bytes.Offset, bytes.Count, writable: false),
        new XmlReaderSettings
        {
            DtdProcessing = DtdProcessing.Prohibit,
            XmlResolver = null,
            MaxCharactersInDocument = MostCharacters,
            IgnoreComments = true,
            IgnoreProcessingInstructions = true,
            IgnoreWhitespace = true,
        });
}
