namespace UnityEngine
{
    /// <summary>What a coroutine waits for.</summary>
    public class YieldInstruction { }

    /// <summary>Until the next fixed step is done, the engine's physics too.</summary>
    public sealed class WaitForFixedUpdate : YieldInstruction { }
}
