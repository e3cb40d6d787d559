using System.Globalization;
using System.Text.RegularExpressions;
using NUnit.Framework;
using RigidBodyDynamics.UnityFiles;
using YamlDotNet.RepresentationModel;

namespace RigidBodyDynamics.Tests.UnityProject;

/// <summary>The bodies of the scenes and their starts.</summary>
public sealed partial class SceneMotionTests
{
    private static readonly string[] Defaults = ["MyRigidbody", "DefaultRigidbody"];

    [Test]
    public void Lab_has_a_cube_and_a_box_each_of_mine_and_beside_it_the_one_it_is_compared_with()
    {
        SceneObject[] bodies = Bodies();

        Assert.That(bodies.Select(body => body.Name), Is.EqualTo(new[] { "My cube", "Default cube", "My box", "Default box" }));
        Assert.That(bodies.Select(body => body.Scale), Is.EqualTo(new[] { new Vector3d(1, 1, 1), new Vector3d(1, 1, 1), new Vector3d(1, 2, 3), new Vector3d(1, 2, 3) }));
        foreach ((SceneObject mine, SceneObject theirs) in new[] { (bodies[0], bodies[1]), (bodies[2], bodies[3]) })
        {
            Assert.That(mine["MyRigidbody"]!["comparedWith"]!.FileId(), Is.EqualTo(theirs["DefaultRigidbody"]!.FileId));
            Assert.That(new[] { mine["Rigidbody"], mine["BoxCollider"], theirs["MyRigidbody"] }, Is.All.Null);
            Assert.That(Value(theirs["Rigidbody"]!, "m_UseGravity"), Is.EqualTo("0"));
            Assert.That(Value(theirs["Rigidbody"]!, "m_Mass"), Is.EqualTo(Value(mine["MyRigidbody"]!, "mass")));
        }
    }

    [Test]
    public void Lab_starts_with_what_the_scripts_say([ValueSource(nameof(Defaults))] string script)
    {
        foreach (UnityObject component in Bodies().Select(body => body[script]).OfType<UnityObject>())
        {
            foreach (Match field in PublicField().Matches(Change.Text($"{Change.Sources}{script}.cs")).Where(field => field.Groups["name"].Value != "comparedWith"))
            {
                string found = Value(component, field.Groups["name"].Value), type = field.Groups["type"].Value;
                Assert.That(found, Is.EqualTo(Written(type, field.Groups["value"].Value)), field.Value);
            }
        }
    }

    // All pushes are along x and y and the same for all. Unity's bodies keep their places to each other; mine are damped
    // otherwise, but the depth between them stays.
    [Test]
    public void Lab_bodies_cannot_touch_whatever_key_is_held()
    {
        SceneObject[] bodies = Bodies();
        foreach (SceneObject a in bodies)
        {
            foreach (SceneObject b in bodies.Where(other => other.Name.CompareTo(a.Name, StringComparison.Ordinal) > 0))
            {
                bool together = a["Rigidbody"] == null == (b["Rigidbody"] == null);
                double apart = together ? (a.Position - b.Position).Length : Math.Abs(a.Position.Z - b.Position.Z);

                // half diagonals, which bound any orientation
                Assert.That(apart, Is.GreaterThan((a.Scale.Length + b.Scale.Length) / 2), $"{a.Name}, {b.Name}");
            }
        }
    }

    [Test]
    public void Slabs_are_alike_but_for_the_integrator_that_they_are_named_after()
    {
        SceneObject[] slabs = Slabs();
        IEnumerable<string> fields = slabs.Select(slab => string.Join('\n', slab["MyRigidbody"]!.Fields.Children
            .Where(field => $"{field.Key}" is not ("integrator" or "m_GameObject")).Select(field => $"{field.Key} {field.Value}")));

        Assert.That(slabs.Select(slab => slab.Name), Is.EqualTo(new[] { "LabEuler", "ImplicitGyroscopic", "RungeKutta4", "Exact" }));
        Assert.That(slabs.Select(slab => Value(slab["MyRigidbody"]!, "integrator")), Is.EqualTo(slabs.Select(slab => slab.Name)));
        Assert.That(fields.Distinct().Count(), Is.EqualTo(1));
        Assert.That(slabs.Select(slab => slab.Scale).Distinct().Count(), Is.EqualTo(1));
    }

    [TestCase("LabEuler", null)]
    [TestCase("ImplicitGyroscopic", 3.28)]
    [TestCase("RungeKutta4", 3.38)]
    [TestCase("Exact", 3.38)]
    public void Slab_flips_when_it_should_and_by_the_integrator_of_the_lab_never(string name, double? first)
    {
        SceneObject slab = Slabs().Single(found => found.Name == name);
        UnityObject mine = slab["MyRigidbody"]!;
        // solid box, no damping, no keys
        Assert.That(new[] { "inertia", "damping", "readsKeys", "mass" }.Select(field => Value(mine, field)), Is.EqualTo(new[] { "1", "2", "0", "1" }));
        MassProperties mass = Solids.Box(1, slab.Scale);
        Vector3d moments = mass.PrincipalMoments, spin = SceneObject.Vector(mine["startSpin"]!);
        double[] sorted = [.. new[] { moments.X, moments.Y, moments.Z }.Order()];
        Simulation simulation = new(
            TimeSteps.Every(0.02),
            new BodyDescription(name, mass) { Rule = Rules.Named(name), Start = new BodyState(slab.Position, Quaterniond.Identity, Vector3d.Zero, spin) });

        // the end that is painted, along x, which is the middle axis
        double? turned = null;
        for (int step = 1; step <= 1500 && turned == null; step++)
        {
            simulation.Step();
            if (simulation.Bodies[0].State.Orientation.Rotate(new Vector3d(1, 0, 0)).X < 0)
                turned = step * 0.02;
        }

        Assert.That(moments.X, Is.EqualTo(sorted[1]));
        Assert.That(sorted[1] / sorted[0], Is.GreaterThan(1.3));
        Assert.That(sorted[2] / sorted[1], Is.GreaterThan(1.3));
        Assert.That(turned, first == null ? Is.Null : Is.EqualTo(first).Within(1e-9));
    }

    private static SceneObject[] Bodies() => [.. SceneObject.All(Change.LabScene).Where(found => found["MyRigidbody"] != null || found["DefaultRigidbody"] != null)];

    private static SceneObject[] Slabs() => [.. SceneObject.All(Change.SlabScene).Where(found => found["MyRigidbody"] != null)];

    private static string Value(UnityObject component, string field) =>
        component[field] is YamlScalarNode value ? value.Text() : $"{SceneObject.Vector(component[field]!)}";

    // how Unity writes what stands after a field in the source
    private static string Written(string type, string source) => source switch
    {
        "" or "false" => type == "Vector3" ? $"{Vector3d.Zero}" : "0",
        "true" => "1",
        _ when type is "double" or "float" => double.Parse(source.TrimEnd('f'), CultureInfo.InvariantCulture).ToString(CultureInfo.InvariantCulture),
        _ when type == "string" => source.Trim('"'),
        "InertiaKind.LabVertices" or "DampingKind.FactorPerStep" => "0",
        _ => source,
    };

    [GeneratedRegex(@"^        public (?<type>\w+) (?<name>\w+)( = (?<value>[^;]+))?;", RegexOptions.Multiline)]
    private static partial Regex PublicField();
}
