using UnityEngine;

namespace RigidBodyDynamics.Scripts
{
    /// <summary>What the panel says, in one language at a time: that of the system at first, then as the button says.</summary>
    internal static class Words
    {
        private static bool? _isChinese;

        /// <summary>True where it is said in Chinese.</summary>
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
