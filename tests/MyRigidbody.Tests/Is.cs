using NUnit.Framework.Constraints;

namespace RigidBodyDynamics.Tests;

/// <summary>NUnit's, with one difference: there NaN is less than any bound, and a failing integrator would pass.</summary>
internal abstract class Is : NUnit.Framework.Is
{
    /// <summary>Less, and a number.</summary>
    public static new Constraint LessThan(object bound) => Not.NaN.And.LessThan(bound);

    /// <summary>At most, and a number.</summary>
    public static new Constraint LessThanOrEqualTo(object bound) => Not.NaN.And.LessThanOrEqualTo(bound);
}
