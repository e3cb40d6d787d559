using System.Text.Json;
using System.Text.RegularExpressions;
using System.Xml;
using NUnit.Framework;
using RigidBodyDynamics.Lab.Languages;

namespace RigidBodyDynamics.Tests.Languages;

/// <summary>What the framework says of a damaged file is said in Chinese too.</summary>
public sealed class DamagedTextTests
{
    private const string Json = "{\"a\": [1, -2.5e3, true, false, null], // x\n \"b\": {\"c\": \"d\\u00e9\"}}";
    private const string Xml = "<?xml version=\"1.0\"?><robot name=\"a\"><!-- x --><link name=\"b\"><mass value=\"1\"/></link></robot>";
    private static readonly string[] Put = ["", "}", "]", ",", ":", "\"", "/", "\\", "x", "0", "-", ".", "<", ">", "&", "=", "'", "\u0001"];

    private static readonly JsonDocumentOptions AsScenes = new() { AllowTrailingCommas = true, CommentHandling = JsonCommentHandling.Skip, AllowDuplicateProperties = false };

    [Test]
    public void Damaged_JSON_is_refused_in_Chinese() => Assert.That(Said(Json, text => JsonDocument.Parse(text, AsScenes).Dispose(), " LineNumber:", atLeast: 15), Is.Empty);

    [Test]
    public void Damaged_XML_is_refused_in_Chinese() => Assert.That(Said(Xml, Read, " Line ", atLeast: 15), Is.Empty);

    private static void Read(string text)
    {
        using XmlReader reader = XmlReader.Create(new StringReader(text));
        while (reader.Read())
        {
        }
    }

    /// <summary>Every text that is cut off, or has something put in or in place of a letter; what is said of it in English where Chinese is due.</summary>
    private static string[] Said(string right, Action<string> read, string end, int atLeast)
    {
        HashSet<string> said = [];
        foreach (int at in Enumerable.Range(0, right.Length))
        {
            foreach (string text in Put.SelectMany(put => new[] { right[..at] + put, right[..at] + put + right[at..], right[..at] + put + right[(at + 1)..] }))
            {
                try
                {
                    read(text);
                }
                catch (Exception broken) when (broken is JsonException or XmlException)
                {
                    said.Add(broken.Message.Split(end)[0].Split(" Path:")[0].ReplaceLineEndings(" "));
                }
            }
        }

        Assert.That(said, Has.Count.GreaterThan(atLeast));
        // between the quotes is what stands in the file
        return [.. said.Where(message => Sentences.InChinese(message) == message || EnglishSentences.In(Regex.Replace(Sentences.InChinese(message), "'.*'|m?a?s{0,2}, link, robot", "…")).Any())];
    }
}
