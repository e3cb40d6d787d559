using System.Text;
using CsCheck;
using NUnit.Framework;
using RigidBodyDynamics.Lab;
using RigidBodyDynamics.Lab.Meshes;
using RigidBodyDynamics.Lab.Output;
using RigidBodyDynamics.Tests.CommandLine;
using RigidBodyDynamics.Tests.SceneFiles;

namespace RigidBodyDynamics.Tests;

/// <summary>STL and OBJ: what is read, and what is refused with the line that says why.</summary>
public sealed class MeshFileTests
{
    private static readonly Surface Cube = Surface.Box(new Vector3d(1, 2, 4));

    [Test]
    public void Three_ways_to_write_a_surface_are_read_to_the_same_bits()
    {
        MassProperties box = Solids.Mesh(3, Cube.Vertices, Cube.Triangles);
        foreach ((string name, byte[] bytes) in new[]
        {
            ("a.stl", Encoding.UTF8.GetBytes(MeshText.Stl(Cube))), ("b.STL", MeshText.BinaryStl(Cube)), ("c.obj", Encoding.UTF8.GetBytes(MeshText.Obj(Cube))),
            ("d.stl", Encoding.UTF8.GetBytes(MeshText.Stl(Cube).Replace("\n", "\r\n  ").ToUpperInvariant())), ("e.obj", Encoding.UTF8.GetBytes("\uFEFF# 零件\r\n" + MeshText.Obj(Cube))),
        })
        {
            MeshFile mesh = Read(name, bytes);
            Assert.That((mesh.Vertices.Length, mesh.Triangles.Length), Is.EqualTo((8, 36)), name);
            Assert.That(mesh.Weighing(3).Inertia.Diagonal, Is.EqualTo(box.Inertia.Diagonal), name);
        }
    }

    [TestCase("v 0 0 0\nv 1 0 0\nv 1 1 0\nv 0 1 0\nv 0 0 1\nv 1 0 1\nv 1 1 1\nv 0 1 1\nf 1/1 4/2 3/3 2/4\nf 5//1 6//1 7//1 8//1\nf -8 -7 -3 -4\nf 2 3 7 6\nf 3 4 8 7\nf 4 1 5 8 # end")]
    [TestCase("mtllib a.mtl\no cube\nv 0 0 0 1\nv 1 0 0 1\nv 1 1 0\nv 0 1 0\nv 0 0 1\nv 1 0 1\nv 1 1 1\nv 0 1 1\nvn 0 0 1\nvt 0 0\ng a\nusemtl m\ns off\nf 1 4 \\\n3 2\nf 5 6 7 8\nf 1 2 6 5\nf 2 3 7 6\nf 3 4 8 7\nf 4 1 5 8\nl 1 2\n")]
    public void Faces_of_four_corners_and_what_else_stands_in_an_obj(string text)
    {
        MeshFile mesh = Read("cube.obj", Encoding.UTF8.GetBytes(text));

        Assert.That(mesh.OfDensity(12).Mass, Is.EqualTo(12));
        Assert.That(mesh.Weighing(6).PrincipalMoments, Is.EqualTo(new Vector3d(1, 1, 1)));
        Assert.That(mesh.Weighing(6).CenterOfMass, Is.EqualTo(new Vector3d(0.5, 0.5, 0.5)));
    }

    [Test]
    public void Corners_that_differ_by_a_bit_are_two_and_minus_zero_is_zero()
    {
        Surface shifted = Surface.Box(new Vector3d(2, 2, 2)).Moved(new Vector3d(1, 1, 1));
        string text = MeshText.Stl(shifted);
        int first = text.IndexOf("vertex 0 0 0", StringComparison.Ordinal);
        string minus = text[..first] + "vertex -0.0 0 -0" + text[(first + "vertex 0 0 0".Length)..], off = text[..first] + "vertex 1e-300 0 0" + text[(first + "vertex 0 0 0".Length)..];

        Assert.That(Read("minus.stl", Encoding.UTF8.GetBytes(minus)).OfDensity(1).Mass, Is.EqualTo(8));
        Assert.That(() => Read("off.stl", Encoding.UTF8.GetBytes(off)).OfDensity(1), Throws.InstanceOf<InputException>().With.Message.Contains("off.stl: triangles: must be a closed surface"));
    }

    [Test]
    public void Triangle_whose_corners_the_file_rounds_to_two_is_left_out()
    {
        string text = MeshText.Stl(Cube).Replace("endsolid", "facet normal 0 0 0 outer loop vertex 0.5 1 2 vertex 0.5 1 2 vertex -0.5 1 2 endloop endfacet endsolid");
        MeshFile mesh = Read("sliver.stl", Encoding.UTF8.GetBytes(text));

        Assert.That(mesh.Collapsed, Is.EqualTo(1));
        Assert.That(mesh.OfDensity(1).Mass, Is.EqualTo(8));
    }

    [Test]
    public void Mirrored_mesh_stays_right_side_out()
    {
        Surface wedge = Surface.Tetrahedron(new(1, 0, 0.25), new(-0.5, 1, 0), new(0, -0.75, 1.5), new(0.25, 0.25, -1));
        MeshFile mesh = Read("wedge.stl", MeshText.BinaryStl(wedge));
        MassProperties left = mesh.Weighing(1), right = mesh.Scaled(new Vector3d(-1, 1, 1)).Weighing(1), twice = mesh.Scaled(new Vector3d(-1, -1, 1)).Weighing(1);

        Assert.That(right.CenterOfMass, Is.EqualTo(Vector3d.Scale(left.CenterOfMass, new Vector3d(-1, 1, 1))));
        Assert.That((right.Inertia.XY, right.Inertia.XZ, right.Inertia.YZ), Is.EqualTo((-left.Inertia.XY, -left.Inertia.XZ, left.Inertia.YZ)));
        Assert.That(twice.Inertia.XY, Is.EqualTo(left.Inertia.XY));
        Assert.That(() => mesh.Scaled(new Vector3d(1, 0, 1)), Throws.InstanceOf<ArgumentException>().With.Message.StartsWith("scale: "));
    }

    private static readonly TestCaseData[] Broken =
    [
        Wrong("a.stl", "", "is no STL: it does not begin with \"solid\", and 0 bytes are too few"),
        Wrong("a.stl", new string('x', 200), "is no STL, or is cut off: 2021161080 triangles take 101058054084 bytes, and it has 200"),
        Wrong("a.stl", "solid\n", "line 2: must be facet or endsolid, found the end of the file"),
        Wrong("a.stl", "solid\nendsolid\n", "has no triangle"),
        Wrong("a.stl", "solid s\nfacet normal 0 0 1\nouter loop\nvertex 0 0 1,5\n", "line 4: must be a number, found 1,5"),
        Wrong("a.stl", "solid s\nfacet normal 0 0 1\nouter loop\nvertex 0 0 NaN\n", "line 4: a corner must have three finite numbers, found (0, 0, NaN)"),
        Wrong("a.stl", "solid s\nfacet normal 0 0 1\nouter loop\nvertex 0 0 1\nvertex", "line 5: must be a number, found the end of the file"),
        Wrong("a.stl", "solid s\nfacet normal 0 0 1\nouter loop\nvertex 0 0 1\nvertex 1 0 0\nvertex 0 1 0\nvertex 1 1 1", "line 7: must be endloop, found vertex"),
        Wrong("a.stl", "solid s\nendsolid s\nmore", "line 3: must be solid or the end of the file, found more"),
        Wrong("a.obj", "", "has no triangle"),
        Wrong("a.obj", "v 1 2\n", "line 1: v must have three numbers, found the end of the line"),
        Wrong("a.obj", "v 1 2 x\n", "line 1: v must have three numbers, found x"),
        Wrong("a.obj", "v 1 2 3\nf 1 2 3\n", "line 2: there is no vertex 2: 1 stand above"),
        Wrong("a.obj", "v 1 2 3\nf 0 1 1\n", "line 2: there is no vertex 0: 1 stand above"),
        Wrong("a.obj", "v 1 2 3\nf -2 1 1\n", "line 2: there is no vertex -2: 1 stand above"),
        Wrong("a.obj", "v 1 2 3\nf 1 1\n", "line 2: f must have at least three corners, found 2"),
        Wrong("a.obj", "v 1 2 3\nf 99999999999 1 1\n", "line 2: a corner of f must be the number of a v, found 99999999999"),
        Wrong("a.obj", "v 1 2 3\n\ncstype bspline\n", "line 3: cstype is of a free-form surface, which is not understood: export triangles"),
        Wrong("a.obj", "v 1e999 2 3\n", "line 1: a corner must have three finite numbers, found (Infinity, 2, 3)"),
        Wrong("a.ply", "ply", "must be a mesh in STL or OBJ"),
    ];

    [TestCaseSource(nameof(Broken))]
    public void Broken_file_is_refused_in_one_line(string name, string text, string expected)
    {
        InputException refused = Caught(() => Read(name, Encoding.UTF8.GetBytes(text)));

        Assert.That(refused.Message, Does.Contain($"{name}: {expected}").And.Not.Contains("\n"));
    }

    [TestCase(0xFFFFFFFFu, "is no STL, or is cut off: 4294967295 triangles take 214748364834 bytes, and it has 684")]
    [TestCase(13u, "is no STL, or is cut off: 13 triangles take 734 bytes, and it has 684")]
    [TestCase(11u, "is no STL, or is cut off: 11 triangles take 634 bytes, and it has 684")]
    public void Count_that_the_file_does_not_have_is_refused_before_anything_is_made(uint count, string expected)
    {
        byte[] bytes = MeshText.BinaryStl(Cube);
        bytes[0] = (byte)'x';
        BitConverter.GetBytes(count).CopyTo(bytes, 80);
        long before = GC.GetAllocatedBytesForCurrentThread();

        Assert.That(Caught(() => Read("count.stl", bytes)).Message, Does.Contain(expected));
        long allocated = GC.GetAllocatedBytesForCurrentThread() - before;
        TestContext.Out.WriteLine(allocated);
        Assert.That(allocated, Is.LessThan(200_000)); // measured 10,384
    }

    [Test]
    public void Not_a_number_in_single_precision_is_refused_with_its_triangle()
    {
        byte[] bytes = MeshText.BinaryStl(Cube);
        BitConverter.GetBytes(float.NaN).CopyTo(bytes, 84 + (50 * 7) + 12);

        Assert.That(Caught(() => Read("nan.stl", bytes)).Message, Does.Contain("nan.stl: triangle 8: a corner must have three finite numbers"));
    }

    [Test]
    public void Whatever_is_done_to_a_file_the_answer_is_a_solid_or_one_line()
    {
        byte[][] files = [MeshText.BinaryStl(Cube), Encoding.UTF8.GetBytes(MeshText.Stl(Cube)), Encoding.UTF8.GetBytes(MeshText.Obj(Cube))];
        string[] names = ["f.stl", "f.stl", "f.obj"];
        int solids = 0;
        Gen.Select(Gen.Int[0, 2], Gen.Double[0, 1], Gen.Int[0, 60], Gen.Byte.Array[0, 6]).Sample(
            edit =>
            {
                (int which, double where, int length, byte[] insert) = edit;
                int at = (int)(where * files[which].Length);
                byte[] bytes = [.. files[which][..at], .. insert, .. files[which][Math.Min(files[which].Length, at + length)..]];
                try
                {
                    MassProperties solid = Read(names[which], bytes).Weighing(1);
                    solids++;
                    return solid.PrincipalMoments.IsFinite;
                }
                catch (InputException refused)
                {
                    return !refused.Message.Contains('\n') && refused.Message.Contains(names[which]);
                }
            },
            iter: 2000,
            threads: 1);
        TestContext.Out.WriteLine(solids);
        Assert.That(solids, Is.GreaterThan(20)); // measured 72 of 2000: those whose names or normals were hit
    }

    [Test]
    public void Scene_has_a_body_of_a_mesh_beside_it_by_every_integrator()
    {
        foreach (Rule rule in Rules.All)
        {
            SceneFile file = SceneText.Read($$"""
                { "schema": "rigid-body-scene/1", "name": "n", "step": 0.01, "steps": 5, "bodies": [
                  { "name": "a", "integrator": "{{rule.Name}}", "mass": 12, "angularVelocity": [1, 2, 3], "inertia": { "mesh": "{{SceneText.MeshName}}", "scale": [1, 2, 3] } },
                  { "name": "b", "integrator": "{{rule.Name}}", "mass": 12, "angularVelocity": [1, 2, 3], "inertia": { "solidBox": [1, 2, 3] } },
                  { "name": "c", "inertia": { "compound": [{ "mass": 2, "inertia": { "mesh": "{{SceneText.MeshName}}" } }] } } ] }
                """);
            Simulation simulation = new(file.Scene);
            simulation.Step(5);

            Assert.That(file.Inputs.Select(Path.GetFileName), Is.EqualTo(new[] { "scene.json", SceneText.MeshName }));
            Assert.That(simulation.Bodies[0].State.Orientation, Is.EqualTo(simulation.Bodies[1].State.Orientation), rule.Name);
            Assert.That(simulation.Bodies[2].Mass.Mass, Is.EqualTo(2));
        }
    }

    [Test]
    public void Handle_of_the_gallery_is_two_boxes_and_turns_over_five_times()
    {
        SceneFile file = SceneReader.Read(Path.Combine(Gallery.Folder, "t-handle.json"));
        MassProperties handle = file.Scene.Bodies[0].Mass;
        // 29.4 cm³ of steel: a bar and a stem
        MassProperties boxes = new Compound()
            .With(Solids.Box(handle.Mass * 2 / 3, new Vector3d(0.1, 0.014, 0.014)), new Vector3d(0, 0.007, 0))
            .With(Solids.Box(handle.Mass / 3, new Vector3d(0.014, 0.05, 0.014)), new Vector3d(0, -0.025, 0))
            .ToMassProperties();
        Assert.That((handle.CenterOfMass - boxes.CenterOfMass).Length, Is.LessThan(1e-17)); // measured 3.5e-18
        Assert.That((handle.Inertia.Diagonal - boxes.Inertia.Diagonal).Length / boxes.Inertia.ZZ, Is.LessThan(1e-15)); // measured 4.9e-16

        Simulation simulation = new(file.Scene);
        int turnedOver = 0;
        for (double last = 1; simulation.StepsDone < file.Scene.Steps.Count;)
        {
            simulation.Step();
            double up = simulation.Bodies[0].State.Orientation.Rotate(new Vector3d(0, 1, 0)).Y;
            turnedOver += up * last < 0 ? 1 : 0;
            last = up;
        }

        Assert.That(turnedOver, Is.EqualTo(5));
        TestContext.Out.WriteLine((handle.CenterOfMass - boxes.CenterOfMass).Length);
        TestContext.Out.WriteLine((handle.Inertia.Diagonal - boxes.Inertia.Diagonal).Length / boxes.Inertia.ZZ);
    }

    [TestCase("\"mesh\": \"no.stl\"", "scene.json: bodies[0].inertia.mesh: no.stl: there is no such file")]
    [TestCase("\"mesh\": \"a.ply\"", "scene.json: bodies[0].inertia.mesh: a.ply: must be a mesh in STL or OBJ (.stl, .obj), whose surface is closed")]
    [TestCase("\"mesh\": \"\"", "scene.json: bodies[0].inertia.mesh: ")]
    [TestCase("\"mesh\": 1", "scene.json: bodies[0].inertia.mesh: must be a text, found 1")]
    [TestCase("\"mesh\": \"零件 part.obj\", \"scale\": [1, 0, 1]", "scene.json: bodies[0].inertia.scale: must have three finite factors, none of them zero, found (1, 0, 1)")]
    [TestCase("\"mesh\": \"零件 part.obj\", \"scale\": 2", "scene.json: bodies[0].inertia.scale: must be three numbers [x, y, z], found 2")]
    [TestCase("\"mesh\": \"零件 part.obj\", \"size\": 2", "scene.json: bodies[0].inertia.size: is not a name known here; known are ")]
    public void Scene_says_what_is_wrong_with_its_mesh(string inertia, string expected)
    {
        Assert.That(SceneText.Error($$"""{ "schema": "rigid-body-scene/1", "name": "n", "step": 1, "steps": 1, "bodies": [ { "name": "b", "inertia": { {{inertia}} } } ] }"""), Does.StartWith(expected));
    }

    [Test]
    public void Scene_says_which_edge_of_its_mesh_is_open()
    {
        using TemporaryFolder folder = new();
        File.WriteAllText(folder.File("part.obj"), MeshText.Obj(Cube with { Triangles = Cube.Triangles[..33] }));
        File.WriteAllText(folder.File("s.json"), """{ "schema": "rigid-body-scene/1", "name": "n", "step": 1, "steps": 1, "bodies": [ { "name": "b", "inertia": { "mesh": "part.obj" } } ] }""");

        LabProcess run = LabProcess.Run(folder.Path, "run", "s.json", "--out", "part.obj");

        Assert.That((run.ExitCode, run.Error), Is.EqualTo((2, "error: s.json: bodies[0].inertia.mesh: part.obj: triangles: must be a closed surface, whose every edge is in two triangles, once in each direction, "
            + "and the edge from (0.5, -1, 2) to (0.5, 1, 2) is in triangle 3 alone: the surface is open there; 2 more edges are like that, in body \"b\"\n")));
    }

    [Test]
    public void Mesh_of_a_scene_is_not_written_over()
    {
        using TemporaryFolder folder = new();
        File.WriteAllText(folder.File("part.obj"), MeshText.Obj(Cube));
        File.WriteAllText(folder.File("s.json"), """{ "schema": "rigid-body-scene/1", "name": "n", "step": 1, "steps": 1, "bodies": [ { "name": "b", "inertia": { "mesh": "part.obj" } } ] }""");

        LabProcess run = LabProcess.Run(folder.Path, "run", "s.json", "--out", "part.obj");

        Assert.That((run.ExitCode, run.Error), Is.EqualTo((2, "error: part.obj: is what was read, and would be written over\n")));
    }

    private static InputException Caught(Action read)
    {
        try
        {
            read();
            return new InputException("it was read");
        }
        catch (InputException refused)
        {
            return refused;
        }
    }

    private static MeshFile Read(string name, byte[] bytes)
    {
        using TemporaryFolder folder = new();
        File.WriteAllBytes(folder.File(name), bytes);
        return MeshFile.Read(folder.File(name));
    }

    private static TestCaseData Wrong(string name, string text, string expected) => new TestCaseData(name, text, expected).SetArgDisplayNames(name, expected);
}
