using System.Collections;
using System.Globalization;
using System.Reflection;
using NUnit.Framework;

namespace RigidBodyDynamics.Tests;

/// <summary>
/// Every public constructor, method and setter of the library, found by reflection, gets one invalid value among sound
/// ones.
/// </summary>
public sealed class EveryEntryTests
{
    // arithmetic passes NaN and infinity through, as IEEE 754 says
    private static readonly Type[] Arithmetic =
    [
        typeof(Vector3d), typeof(Quaterniond), typeof(SymmetricMatrix3), typeof(Elementary), typeof(Conserved), typeof(Coasting),
        typeof(Wrench), typeof(Instant), typeof(BodyState),
    ];

    // called in every step, by a simulation that has checked its input at the start
    private static readonly string[] InnerLoop =
        [nameof(IPush.At), nameof(IPush.Over), nameof(ICoast.AddTo), nameof(IIntegrator.Start), nameof(IIntegrator.Push), nameof(IIntegrator.Prepare), nameof(IIntegrator.Step)];

    private static IEnumerable<TestCaseData> Checked() => Entry.All
        .Where(entry => !Arithmetic.Contains(entry.Type) && !(entry.Type.IsValueType && InnerLoop.Contains(entry.Method.Name)))
        .Select(entry => new TestCaseData(entry).SetArgDisplayNames(entry.ToString()));

    [TestCaseSource(nameof(Checked))]
    public void One_hostile_argument_is_refused_by_name_and_value_or_has_a_finite_answer(object tried)
    {
        Entry entry = (Entry)tried;
        ParameterInfo[] parameters = entry.Method.GetParameters();
        for (int i = 0; i < parameters.Length; i++)
        {
            foreach (object? hostile in parameters[i].IsOut ? [] : Values.Hostile(Entry.Plain(parameters[i])))
            {
                string what = string.Create(CultureInfo.InvariantCulture, $"{entry}, {parameters[i].Name} = {hostile ?? "null"}");
                try
                {
                    foreach (object? result in entry.Call(i, hostile))
                        Assert.That(IsFinite(result), Is.True, what + " answers " + result);
                }
                catch (ArgumentException refused)
                {
                    Assert.That(refused.ParamName, Is.Not.Null.And.Not.Empty, what);
                    Assert.That(refused.Message, Does.Contain(refused.ParamName!).And.Not.Contains("\n"), what);
                    if (refused is ArgumentOutOfRangeException { ActualValue: double value })
                        Assert.That(refused.Message, Does.EndWith("found " + value.ToString("R", CultureInfo.InvariantCulture)), what);
                }
            }
        }
    }

    /// <summary>All numbers in it, public ones, are finite; infinity is what an unlimited setting says.</summary>
    private static bool IsFinite(object? value) => value switch
    {
        double number => double.IsFinite(number),
        Vector3d vector => vector.IsFinite,
        Quaterniond quaternion => quaternion.IsFinite,
        BodyState state => state.IsFinite,
        null or string or bool or int or long or Enum or Delegate or Type => true,
        IEnumerable items => items.Cast<object?>().All(IsFinite),
        MassProperties mass => IsFinite(mass.Mass) && IsFinite(mass.InverseMass) && IsFinite(mass.PrincipalMoments) && IsFinite(mass.InversePrincipalMoments)
            && IsFinite(mass.PrincipalFrame) && IsFinite(mass.Inertia.Diagonal) && IsFinite(mass.Inertia.OffDiagonal) && IsFinite(mass.CenterOfMass),
        _ => true,
    };
}
