using System.Globalization;
using System.Text.Json;
using NUnit.Framework;

namespace RigidBodyDynamics.Tests;

/// <summary>The lab's script, held against the same updates in exact arithmetic: 500 steps, all keys pressed.</summary>
public sealed class LabDiscreteTests
{
    // measured, in floors: angle 4.2, 5.9, 9.3, 5.6, 4.2; components 1.9, 2.1, 4.2, 3.0, 1.9; spin 4.5, 1.7, 1.5, 1.9, 4.5
    [TestCase("lab_discrete_a")]
    [TestCase("lab_discrete_b")]
    [TestCase("lab_discrete_c")]
    [TestCase("lab_discrete_c_unit_rotation")]
    [TestCase("lab_discrete_d")]
    public void Script_is_repeated_to_within_ten_times_what_the_last_bit_of_its_inputs_does(string id)
    {
        ExactCase exact = ExactCase.Read(id);
        Simulation simulation = new(TimeSteps.Every(1.0 / 60, exact.Inputs.GetProperty("steps").GetInt64()), Described(exact.Inputs));
        double floor = 0, angle = 0, spin = 0, components = 0, place = 0, speed = 0;
        foreach (ExactCase.Sample sample in exact.Samples)
        {
            if (sample.Time > 0)
                simulation.Step();
            BodyState state = simulation.Bodies[0].State;
            // the floor is not monotonic
            floor = Math.Max(floor, sample["double_attainable_error"]);
            angle = Math.Max(angle, Conserved.AngleBetween(state.Orientation, sample.Orientation) / floor);
            components = Math.Max(components, Samples.Apart(state.Orientation, sample.Orientation) / floor);
            spin = Math.Max(spin, Samples.Apart(state.AngularVelocity, sample.AngularVelocity) / floor);
            place = Math.Max(place, Samples.Apart(state.Position, sample.Position));
            speed = Math.Max(speed, Samples.Apart(state.Velocity, sample.Velocity));
        }

        TestContext.Out.WriteLine(string.Create(
            CultureInfo.InvariantCulture, $"in floors: angle {angle:g2}, components {components:g2}, spin {spin:g2}"));
        Assert.That(simulation.StepsDone, Is.EqualTo(500));
        Assert.That(angle, Is.LessThan(10));
        // the length of q counts too: in the variants that do not normalise it ends 0.0015 above 1
        Assert.That(components, Is.LessThan(10));
        Assert.That(spin, Is.LessThan(10));
        Assert.That(place, Is.LessThan(2e-14)); // measured 3.6e-15 of 4.7 m
        Assert.That(speed, Is.LessThan(5e-15)); // measured 1.8e-15 of 2.9 m/s
    }

    [Test]
    public void Variants_differ_from_one_another_by_far_more_than_that_where_they_differ_at_all()
    {
        Vector3d a = ExactCase.Read("lab_discrete_a").Samples[^1].Position, d = ExactCase.Read("lab_discrete_d").Samples[^1].Position;
        Quaterniond b = ExactCase.Read("lab_discrete_b").Samples[^1].Orientation;
        Quaterniond c = ExactCase.Read("lab_discrete_c").Samples[^1].Orientation;
        Quaterniond unit = ExactCase.Read("lab_discrete_c_unit_rotation").Samples[^1].Orientation;
        Assert.That(Samples.Apart(a, d), Is.GreaterThan(0.02)); // measured 0.083: F/m dt² for each of the 60 steps of a push
        Assert.That(Conserved.AngleBetween(b, c), Is.EqualTo(2e-4).Within(0.2e-4)); // measured 2.01e-4
        // the update of q is linear in q: with R from a unit copy its length changes nothing
        Assert.That(Conserved.AngleBetween(b, unit), Is.LessThan(1e-15)); // measured 2.4e-16
        Assert.That(c.Length, Is.EqualTo(1.00152).Within(1e-5)); // measured 1.001523
    }

    private static BodyDescription Described(JsonElement inputs)
    {
        bool oldVelocity = inputs.GetProperty("position_update").GetString() == "old_velocity";
        MassProperties mass = inputs.TryGetProperty("box_full_edges", out JsonElement edges)
            ? PointMasses.BoxVertices(1, Vector(edges))
            : Solids.Box(1, new Vector3d(1, 1, 1));
        BodyDescription body = new("cube", mass)
        {
            Rule = oldVelocity ? Rules.ExplicitEuler : Rules.LabEuler,
            Lab = new LabSettings
            {
                Normalise = inputs.GetProperty("normalise").GetBoolean(),
                UnitRotation = inputs.TryGetProperty("rotation_from", out _),
            },
        };
        body.With(new DecayPerStep(inputs.GetProperty("linear_decay").GetDouble(), inputs.GetProperty("angular_decay").GetDouble()));
        foreach (JsonElement key in inputs.GetProperty("keys").EnumerateArray())
        {
            double from = key.GetProperty("from").GetDouble(), to = key.GetProperty("to").GetDouble();
            if (key.GetProperty("type").GetString() == "torque")
                body.With(new KeyPush(LabKey.R), from, to);
            else
                body.With(new Force(Vector(key.GetProperty("value"))), from, to);
        }

        return body;
    }

    private static Vector3d Vector(JsonElement list) => new(list[0].GetDouble(), list[1].GetDouble(), list[2].GetDouble());
}
