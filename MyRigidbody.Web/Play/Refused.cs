using RigidBodyDynamics.Lab.Languages;

namespace RigidBodyDynamics.Web.Play;

/// <summary>Why something cannot be played or measured, in both languages, for a page that may change from one to the other.</summary>
internal static class Refused
{
    // lab.js cuts here: it stands in no message
    private const char Between = '\u001e';

    /// <summary>One line in English and the same in Chinese.</summary>
    public static string InBoth(string message)
    {
        Word said = Words.Said(message.ReplaceLineEndings(" ").Replace(Between, ' '));
        return said.En + Between + said.Zh;
    }
}
