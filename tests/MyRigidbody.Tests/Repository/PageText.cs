namespace RigidBodyDynamics.Tests.Repository;

/// <summary>Parts of a page that a test holds against the program.</summary>
internal static class PageText
{
    /// <summary>The lines of the code block after a comment.</summary>
    public static string[] Block(string page, string after) =>
        [.. File.ReadLines(Root.File(page)).SkipWhile(line => line != after).Skip(2).TakeWhile(line => line != "```")];
}
