using System;
using System.Collections;
using System.Collections.Generic;
using UnityEngine;

namespace RigidBodyDynamics.Engine
{
    /// <summary>A moment of a frame.</summary>
    public enum Moment
    {
        /// <summary>After a fixed step and the engine's physics.</summary>
        AfterFixedStep,

        /// <summary>Every Update has been called.</summary>
        AfterUpdate,

        /// <summary>The frame is drawn.</summary>
        AfterFrame,
    }

    /// <summary>Plays frames of any length, each in Unity's order.</summary>
    public static class Player
    {
        private const double UsualFrame = 1.0 / 60;

        /// <summary>Plays one frame of a length in seconds.</summary>
        public static void Frame(double seconds)
        {
            foreach (Moment moment in Moments(seconds))
                _ = moment;
        }

        /// <summary>Plays one frame, with a stop at each of its moments.</summary>
        /// <param name="seconds">Its length.</param>
        /// <param name="beforeScripts">Called before every FixedUpdate and Update of all scripts, to hold keys by the game's time.</param>
        public static IEnumerable<Moment> Moments(double seconds, Action beforeScripts = null)
        {
            World.LoadIfDue();
            Clock.BeginFrame(seconds);
            foreach (MonoBehaviour script in World.Scripts.ToArray())
                script.StartIfDue();

            while (Clock.BeginFixedStep())
            {
                beforeScripts?.Invoke();
                Tell("FixedUpdate");
                if (Physics.IsAutomatic)
                    Physics.Step(Clock.FixedDeltaTime);

                Coroutines.AfterFixedStep();
                yield return Moment.AfterFixedStep;
            }

            beforeScripts?.Invoke();
            Tell("Update");
            yield return Moment.AfterUpdate;

            Tell("LateUpdate");
            Gizmos.Rays.Clear();
            Tell("OnDrawGizmos");
            Gui.Frame();
            World.DestroyDoomed();
            Keys.EndFrame();
            yield return Moment.AfterFrame;
        }

        /// <summary>The window gets or loses the keyboard.</summary>
        public static void Focus(bool hasFocus) => Tell("OnApplicationFocus", hasFocus);

        /// <summary>The system pauses or resumes the game.</summary>
        public static void Pause(bool isPaused) => Tell("OnApplicationPause", isPaused);

        /// <summary>Runs a test that waits: null for the next frame, WaitForFixedUpdate for the next fixed step.</summary>
        public static void Run(IEnumerator test)
        {
            IEnumerator<Moment> time = Endless().GetEnumerator();
            Stack<IEnumerator> waiting = new Stack<IEnumerator>();
            waiting.Push(test);
            while (waiting.Count > 0)
            {
                if (!waiting.Peek().MoveNext())
                    waiting.Pop();
                else if (waiting.Peek().Current is IEnumerator inner)
                    waiting.Push(inner);
                else if (World.IsPlaying)
                    WaitFor(waiting.Peek().Current, time);
            }
        }

        private static IEnumerable<Moment> Endless()
        {
            while (true)
            {
                foreach (Moment moment in Moments(UsualFrame))
                    yield return moment;
            }
        }

        private static void WaitFor(object awaited, IEnumerator<Moment> time)
        {
            Moment moment = awaited == null ? Moment.AfterUpdate
                : awaited is WaitForFixedUpdate ? Moment.AfterFixedStep
                : throw new NotSupportedException("a test cannot wait for " + awaited);

            // at most so many frames: while the time scale is zero no fixed step comes
            for (int i = 0; i < 10000; i++)
            {
                time.MoveNext();
                if (time.Current == moment)
                    return;
            }

            throw new TimeoutException("the test waits for a step that does not come");
        }

        private static void Tell(string message, params object[] arguments)
        {
            foreach (MonoBehaviour script in World.Scripts.ToArray())
            {
                if (script && (script.isActiveAndEnabled || message.StartsWith("OnApplication", StringComparison.Ordinal)))
                {
                    script.StartIfDue();
                    Messages.Send(script, message, arguments);
                }
            }
        }
    }
}
