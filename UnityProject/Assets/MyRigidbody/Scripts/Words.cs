using UnityEngine;

namespace RigidBodyDynamics.Scripts
{
    /// <summary>The panel's texts, in one language at a time: the system's at first, then as the button says.</summary>
    internal static class Words
    {
        private static bool? _isChinese;

        /// <summary>True if the language is Chinese.</summary>
        public static bool AreChinese
        {
            get
            {
                if (_isChinese == null)
                    _isChinese = IsChinese(Application.systemLanguage);

                return _isChinese.Value;
            }

            set => _isChinese = value;
        }

        /// <summary>One of two texts.</summary>
        public static string Say(string english, string chinese) => AreChinese ? chinese : english;

        private static bool IsChinese(SystemLanguage language) =>
            language == SystemLanguage.Chinese || language == SystemLanguage.ChineseSimplified || language == SystemLanguage.ChineseTraditional;
    }
}
