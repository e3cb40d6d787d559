using System.Numerics;
using NUnit.Framework;
using RigidBodyDynamics.Tests.Repository;
using RigidBodyDynamics.UnityFiles.Drawing;
using RigidBodyDynamics.UnityFiles.Shading;
using SkiaSharp;

namespace RigidBodyDynamics.Tests.UnityProject;

/// <summary>The picture that a student sees when a scene opens.</summary>
public sealed class SceneViewTests
{
    // Panel.cs: margin and width, for 720 pixels of height; larger windows have a larger panel, smaller ones the same
    private const float PanelEnd = 8 + 250, DesignWidth = 1280, DesignHeight = 720;

    private static readonly string[] Scenes = [Change.LabScene, Change.SlabScene];
    private static readonly Dictionary<string, DrawnScene> Drawn = Scenes.ToDictionary(scene => scene, scene => DrawnScene.Read(Root.File(scene)));

    [Test]
    public void All_bodies_are_inside_the_window_and_beside_the_panel(
        [ValueSource(nameof(Scenes))] string scene, [Values("1280x720", "1920x1080", "1024x768", "800x450", "2560x1080")] string window)
    {
        int[] size = [.. window.Split('x').Select(int.Parse)];
        float panel = PanelEnd * Math.Max(1, Math.Min(size[1] / DesignHeight, size[0] / DesignWidth));
        foreach (Vector2 corner in Bodies(scene).SelectMany(body => Outline.Of(body, Drawn[scene].View, size[0], size[1])))
        {
            Assert.That(corner.X, Is.InRange(panel + 20, size[0] - 20f));
            Assert.That(corner.Y, Is.InRange(20f, size[1] - 20f));
        }
    }

    [TestCaseSource(nameof(Scenes))]
    public void No_body_hides_another(string scene)
    {
        Vector2[][] outlines = [.. Bodies(scene).Select(body => Outline.Of(body, Drawn[scene].View, Picture.Width, Picture.Height))];
        IEnumerable<(int, int)> pairs = Enumerable.Range(0, outlines.Length).SelectMany(a => Enumerable.Range(0, a).Select(b => (a, b)));

        Assert.That(outlines, Has.Length.EqualTo(4));
        Assert.That(pairs.Where(pair => Outline.Overlap(outlines[pair.Item1], outlines[pair.Item2])), Is.Empty);
    }

    // where the bodies are; names beside them depend on the fonts of the machine
    [TestCase(Change.LabScene, "docs/images/unity-lab.png")]
    [TestCase(Change.LabScene, "docs/images/unity-lab.zh.png")]
    [TestCase(Change.SlabScene, "docs/images/unity-slab.png")]
    public void Picture_in_the_documentation_is_of_the_scene(string path, string picture)
    {
        using SKBitmap drawn = Picture.Bodies(Drawn[path]), kept = SKBitmap.Decode(Root.File(picture));
        SKColor background = drawn.GetPixel(0, 0);
        (SKColor, SKColor)[] bodies = [.. drawn.Pixels.Zip(kept.Pixels).Where(pair => pair.First != background)];
        int of = bodies.Length, other = bodies.Count(pair => Difference(pair.Item1, pair.Item2) > 12);

        TestContext.Out.WriteLine($"{other} of {of} pixels differ");
        Assert.That(of, Is.GreaterThan(20_000));
        Assert.That(other, Is.LessThan(of / 100));
    }

    [Test]
    public void Outlines_overlap_only_where_they_meet()
    {
        Vector2[] square = [new(0, 0), new(2, 0), new(2, 2), new(0, 2)], rhombus = [new(3.1f, 0), new(5.1f, 2), new(3.1f, 4), new(1.1f, 2)];
        Vector2[] inside = [new(0.5f, 0.5f), new(1, 0.5f), new(1, 1)], beside = [.. inside.Select(p => p + new Vector2(2, 0))];

        Assert.That(Outline.Overlap(square, rhombus), Is.True);
        Assert.That(Outline.Overlap(square, [.. rhombus.Select(p => p + new Vector2(1, 0))]), Is.False);
        Assert.That(Outline.Overlap(square, inside), Is.True);
        Assert.That(Outline.Overlap(square, beside), Is.False);
    }

    // up is up, right is right, and z goes away from the camera; the upper edge is half the field of view away
    [TestCase(0, 0, 5, 640, 360)]
    [TestCase(0, 1, 1, 640, 0)]
    [TestCase(1, 0, 1, 1000, 360)]
    [TestCase(-1, -1, 4, 550, 450)]
    public void Camera_of_90_degrees_sees_a_point_where_it_should(float x, float y, float z, float left, float top)
    {
        Viewpoint ahead = new(Vector3.Zero, Quaternion.Identity, 90, 0.3f, Vector3.Zero);
        // to the right about y, by 30 degrees, and what it sees with it
        Quaternion turn = Quaternion.CreateFromAxisAngle(Vector3.UnitY, MathF.PI / 6);
        Viewpoint turned = ahead with { Rotation = turn, Position = new Vector3(3, 4, 5) };
        Vector3 point = new(x, y, z), moved = Vector3.Transform(point, turn) + turned.Position;

        Assert.That(ahead.Project(point, 1280, 720), Is.EqualTo(new Vector3(left, top, z)).Using<Vector3>(IsNear));
        Assert.That(turned.Project(moved, 1280, 720), Is.EqualTo(new Vector3(left, top, z)).Using<Vector3>(IsNear));
    }

    [Test]
    public void Nearer_cube_is_seen_before_the_farther_and_lit_from_where_the_light_comes()
    {
        Vector3 red = Vector3.UnitX, green = Vector3.UnitY;
        DrawnCube near = new("near", null, Matrix4x4.CreateTranslation(0, 0, 3), red);
        DrawnCube far = new("far", null, Matrix4x4.CreateScale(4) * Matrix4x4.CreateTranslation(0, 0, 9), green);
        Viewpoint view = new(Vector3.Zero, Quaternion.Identity, 60, 0.3f, Vector3.Zero);
        foreach (DrawnCube[] cubes in (DrawnCube[][])[[near, far], [far, near]])
        {
            // a face towards the light has all its colour, one turned away half of it
            using SKBitmap lit = Picture.Bodies(new DrawnScene(view, new MattShading(-Vector3.UnitZ, 0.5f, 1), cubes));
            using SKBitmap dark = Picture.Bodies(new DrawnScene(view, new MattShading(Vector3.UnitZ, 0.5f, 1), cubes));

            Assert.That(lit.GetPixel(640, 360), Is.EqualTo(new SKColor(255, 0, 0)));
            Assert.That(lit.GetPixel(640, 220), Is.EqualTo(new SKColor(0, 255, 0)));
            Assert.That(lit.GetPixel(640, 20), Is.EqualTo(new SKColor(0, 0, 0)));
            Assert.That(dark.GetPixel(640, 360), Is.EqualTo(new SKColor(128, 0, 0)));
        }
    }

    private static IEnumerable<DrawnCube> Bodies(string scene) => Drawn[scene].Cubes.Where(cube => cube.Parent == null);

    private static int Difference(SKColor a, SKColor b) => Math.Abs(a.Red - b.Red) + Math.Abs(a.Green - b.Green) + Math.Abs(a.Blue - b.Blue);

    private static bool IsNear(Vector3 a, Vector3 b) => (a - b).Length() < 0.01f;
}
