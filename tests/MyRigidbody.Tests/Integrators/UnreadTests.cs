using NUnit.Framework;

namespace RigidBodyDynamics.Tests;

/// <summary>A push gets only what it declares to read: the rest of the state is left at its default.</summary>
public sealed class UnreadTests
{
    private static readonly BodyState Moving = new(new Vector3d(1, 2, 3), new Quaterniond(0.6, 0, 0.8, 0), new Vector3d(4, 5, 6), new Vector3d(7, 8, 9));

    [Test]
    public void Composition_shows_poses_and_spins_to_those_alone_that_read_them()
    {
        Assert.That(ShownBy<Composition<SphericalTop, Order2>>(EffectTraits.Moves).Orientation.LengthSquared, Is.Zero);
        Assert.That(ShownBy<Composition<SphericalTop, Order2>>(EffectTraits.Moves).AngularVelocity.IsZero, Is.True);
        Assert.That(ShownBy<Composition<SphericalTop, Order2>>(EffectTraits.ReadsOrientation).Orientation, Is.EqualTo(Moving.Orientation));
        Assert.That(ShownBy<Composition<SphericalTop, Order2>>(EffectTraits.ReadsPosition).Position, Is.EqualTo(Moving.Position));
        Assert.That(ShownBy<Composition<SphericalTop, Order2>>(EffectTraits.ReadsAngularVelocity).AngularVelocity, Is.EqualTo(Moving.AngularVelocity));
    }

    [Test]
    public void Runge_Kutta_shows_states_to_those_alone_that_read_one()
    {
        Assert.That(ShownBy<RungeKutta4>(EffectTraits.Moves), Is.EqualTo(default(BodyState)));
        foreach (EffectTraits reads in new[] { EffectTraits.ReadsPosition, EffectTraits.ReadsOrientation, EffectTraits.ReadsVelocity, EffectTraits.ReadsAngularVelocity })
            Assert.That(ShownBy<RungeKutta4>(reads).Velocity, Is.EqualTo(Moving.Velocity), reads.ToString());
    }

    private static BodyState ShownBy<TIntegrator>(EffectTraits traits) where TIntegrator : struct, IIntegrator
    {
        TIntegrator body = default;
        body.Start(new Beginning(new BodyDescription("b", Solids.Sphere(1, 1)) { Start = Moving }));
        body.Prepare(0.1, Coasting.Free);
        Onlooker push = new(traits | EffectTraits.Moves);
        body.Step(new Instant(0, 0), ref push);
        return push.Seen[0];
    }

    private readonly struct Onlooker(EffectTraits traits) : IPush
    {
        public List<BodyState> Seen { get; } = [];

        public EffectTraits Traits => traits;

        public void At(in Instant now, in BodyState body, MassProperties mass, ref Wrench wrench) => Seen.Add(body);

        public void Over(in Instant now, double duration, in BodyState body, MassProperties mass, ref Wrench impulse) => Seen.Add(body);
    }
}
