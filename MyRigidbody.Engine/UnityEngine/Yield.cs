namespace UnityEngine
{
    /// <summary>What a coroutine waits for.</summary>
    public class YieldInstruction { }

    /// <summary>Until the next fixed step and the engine's physics are done.</summary>
    public sealed class WaitForFixedUpdate : YieldInstruction { }

    /// <summary>Until so many seconds of the game's time have passed.</summary>
    public sealed class WaitForSeconds : YieldInstruction
    {
        public WaitForSeconds(float seconds) { }
    }

    /// <summary>Until the frame is drawn.</summary>
    public sealed class WaitForEndOfFrame : YieldInstruction { }

    /// <summary>A routine over many frames.</summary>
    public sealed class Coroutine : YieldInstruction
    {
        internal Coroutine(MonoBehaviour owner, System.Collections.IEnumerator routine)
        {
            Owner = owner;
            Routine = routine;
        }

        internal MonoBehaviour Owner { get; }

        internal System.Collections.IEnumerator Routine { get; }
    }
}
