using System;
using System.Collections;
using NUnit.Framework;
using NUnit.Framework.Interfaces;
using NUnit.Framework.Internal;
using NUnit.Framework.Internal.Builders;
using NUnit.Framework.Internal.Commands;
using RigidBodyDynamics.Engine;

namespace UnityEngine.TestTools
{
    /// <summary>A test that waits for frames and fixed steps: an IEnumerator, run by the player.</summary>
    [AttributeUsage(AttributeTargets.Method)]
    public class UnityTestAttribute : NUnitAttribute, ISimpleTestBuilder, IWrapTestMethod, IImplyFixture
    {
        public TestMethod BuildFrom(IMethodInfo method, Test suite)
        {
            // NUnit requires a result for a method that is not void; the command below does not read it
            TestCaseParameters parameters = new TestCaseParameters { ExpectedResult = null };
            return new NUnitTestCaseBuilder().BuildTestMethod(method, suite, parameters);
        }

        public TestCommand Wrap(TestCommand command) => new Command(command);

        private sealed class Command : DelegatingTestCommand
        {
            public Command(TestCommand innerCommand) : base(innerCommand) { }

            public override TestResult Execute(TestExecutionContext context)
            {
                Player.Run((IEnumerator)Test.Method.Invoke(context.TestObject));
                context.CurrentResult.SetResult(ResultState.Success);
                return context.CurrentResult;
            }
        }
    }
}
