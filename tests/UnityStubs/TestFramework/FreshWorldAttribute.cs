using System;
using NUnit.Framework;
using NUnit.Framework.Interfaces;

[assembly: RigidBodyDynamics.Engine.FreshWorld]

namespace RigidBodyDynamics.Engine
{
    /// <summary>
    /// Every test has a world of its own, in play mode but for those of the namespace Edit; every line in the console at its end
    /// must have been expected; and no two bodies may have come so near that they would touch, except in a test of the category Touching.
    /// </summary>
    [AttributeUsage(AttributeTargets.Assembly)]
    internal sealed class FreshWorldAttribute : Attribute, ITestAction
    {
        public ActionTargets Targets => ActionTargets.Test;

        public void BeforeTest(ITest test)
        {
            World.Scenes = SceneLoader.Scenes;
            Touching.IsWatched = true;
            World.Begin(isPlaying: !test.ClassName.Contains(".Edit."));
            Touching.IsExpected = test.Properties["Category"].Contains("Touching");
        }

        public void AfterTest(ITest test)
        {
            string fault = UnityConsole.Fault();
            if (Touching.Pairs.Count > 0 && !Touching.IsExpected)
                fault = fault ?? "would touch: " + string.Join(", ", Touching.Pairs);

            World.End();
            // a test that failed has said why
            if (TestContext.CurrentContext.Result.Outcome.Status != TestStatus.Failed)
                Assert.That(fault, Is.Null);
        }
    }
}
