using System.Xml.Linq;
using RigidBodyDynamics.Lab.Output;

namespace RigidBodyDynamics.Lab.Inertia.Robots;

/// <summary>
/// Reads the bodies of an MJCF: inertial (fullinertia in the order xx, yy, zz, xy, xz, yz, about pos), or geoms where there is none
/// (mujoco.readthedocs.io, XML reference). It reports what it does not implement.
/// </summary>
internal sealed class MjcfReader
{
    private static readonly string[] Elsewhere = ["include", "replicate", "composite", "flexcomp", "attach"];
    private readonly string _file;
    private readonly Attributes _attributes;
    private readonly XElement _mujoco;
    private readonly MjcfDefaults _defaults;
    private readonly MjcfTurns _turns;
    private readonly MjcfGeoms _geoms;
    private readonly string _fromGeoms;
    private readonly double[] _groups;
    private readonly List<string> _notes = [];

    public MjcfReader(string file, XElement mujoco)
    {
        (_file, _mujoco, _attributes) = (file, mujoco, new Attributes(file));
        if (Compiler("coordinate", "local") != "local")
            throw new InputException($"{file}: compiler coordinate=\"{Compiler("coordinate", "local")}\" is not understood; MuJoCo has given it up, too: save the model anew");

        _defaults = new MjcfDefaults(mujoco);
        _turns = new MjcfTurns(_attributes, Compiler("angle", "degree") != "radian", Compiler("eulerseq", "xyz"));
        _geoms = new MjcfGeoms(_attributes, _turns, new RobotMeshes(file), mujoco, Compiler("meshdir", Compiler("assetdir", string.Empty)), Compiler("strippath", "false") == "true");
        _fromGeoms = Compiler("inertiafromgeom", "auto");
        XElement? compiler = Settings().LastOrDefault(element => element.Attribute("inertiagrouprange") != null);
        _groups = compiler == null ? [0, 5] : _attributes.Numbers(compiler, "inertiagrouprange", 2, 2)!;
        foreach ((string name, string off) in new[] { ("settotalmass", "-1"), ("boundmass", "0"), ("boundinertia", "0"), ("balanceinertia", "false"), ("discardvisual", "false"), ("fusestatic", "false") })
        {
            if (Compiler(name, off) is string set && set != off)
                _notes.Add($"compiler {name}=\"{set}\" is not applied: the numbers are those before it");
        }

        foreach (XElement element in mujoco.Descendants().Where(element => Elsewhere.Contains(element.Name.LocalName)).Take(5))
            _notes.Add($"{XmlFile.Line(element)}: <{element.Name.LocalName}{(element.Attribute("file") is XAttribute named ? $" file=\"{named.Value}\"" : string.Empty)}> is not followed: bodies that come from there are not listed");
    }

    /// <summary>Notes about the whole file.</summary>
    public IReadOnlyList<string> Notes => _notes;

    /// <summary>All bodies without the world.</summary>
    public IReadOnlyList<DescribedBody> Read()
    {
        List<DescribedBody> bodies = [];
        foreach (XElement world in _mujoco.Elements("worldbody"))
            Bodies(world, world.Attribute("childclass")?.Value, bodies);

        return bodies;
    }

    // the XML reader limits the depth
    private void Bodies(XElement parent, string? inherited, List<DescribedBody> bodies)
    {
        foreach (XElement child in parent.Elements())
        {
            if (child.Name.LocalName is "body" or "frame")
            {
                string? inner = child.Attribute("childclass")?.Value ?? inherited;
                if (child.Name.LocalName == "body")
                    bodies.Add(Body(child, inner, bodies.Count + 1));

                Bodies(child, inner, bodies);
            }
        }
    }

    private DescribedBody Body(XElement element, string? childClass, int number)
    {
        List<string> notes = [];
        List<Finding> faults = [];
        IReadOnlyList<MjcfGeom> geoms = [.. Geoms(element, childClass, Vector3d.Zero, Quaterniond.Identity)];
        DescribedBody body = new(element.Attribute("name")?.Value ?? $"body {number}", XmlFile.Line(element)) { Notes = notes, Faults = faults };
        XElement? inertial = element.Elements("inertial").FirstOrDefault();
        if (inertial != null && _fromGeoms != "true")
            return Given(body with { Geometry = Looks(geoms, notes) }, inertial, faults);

        if (inertial != null)
            notes.Add("compiler inertiafromgeom=\"true\": its inertial is not used");

        if (_fromGeoms == "false")
            return body;

        Geometry whole = new();
        foreach (MjcfGeom geom in geoms.Where(geom => geom.Group >= _groups[0] && geom.Group <= _groups[1]))
        {
            try
            {
                if (_geoms.Solid(geom) is (Shape shape, double density, Vector3d position, Quaterniond turn))
                    whole.Add(shape, position, turn, density);
            }
            catch (ArgumentException refused)
            {
                throw XmlFile.Wrong(_file, geom.Element, refused.Message);
            }
            catch (OmittedException missing)
            {
                notes.Add($"{XmlFile.Line(geom.Element)}: a geom is left out: {missing.Message}");
            }
        }

        if (whole.Count == 0)
            return body;

        try
        {
            MassProperties mass = whole.Whole();
            return body with { Mass = mass.Mass, Center = mass.CenterOfMass, Tensor = mass.Inertia, IsComputed = true, Geometry = whole };
        }
        catch (ArgumentException refused)
        {
            throw XmlFile.Wrong(_file, element, $"its geoms together: {refused.Message}");
        }
    }

    private DescribedBody Given(DescribedBody body, XElement inertial, List<Finding> faults)
    {
        double mass = _attributes.Number(inertial, "mass");
        Vector3d center = _attributes.Vector(inertial, "pos") ?? throw _attributes.Wrong(inertial, "pos is missing");
        double[]? diagonal = _attributes.Numbers(inertial, "diaginertia", 3, 3), full = _attributes.Numbers(inertial, "fullinertia", 6, 6);
        if ((diagonal == null) == (full == null))
            throw _attributes.Wrong(inertial, diagonal == null ? "diaginertia or fullinertia is missing" : "diaginertia and fullinertia exclude each other");

        double[] n = full ?? [.. diagonal!, 0, 0, 0];
        string written = inertial.Attribute(full != null ? "fullinertia" : "diaginertia")!.Value;
        double[] half = [.. TypedDigits.HalfUnits(written.Split((char[]?)null, StringSplitOptions.RemoveEmptyEntries)), 0, 0, 0];
        Quaterniond axes = _turns.Of(inertial);
        if (full != null && axes != Quaterniond.Identity)
            faults.Add(new Finding("full-and-turned", Severity.Wrong, "fullinertia stands beside an orientation, and MuJoCo refuses that: fullinertia has the axes in it"));

        return body with { Mass = mass, Center = center, Axes = axes, Tensor = UrdfReader.Tensor(n), HalfDigits = UrdfReader.Tensor(half), Listed = full };
    }

    /// <summary>The geoms of a body and of the frames in it.</summary>
    private IEnumerable<MjcfGeom> Geoms(XElement parent, string? childClass, Vector3d position, Quaterniond turn)
    {
        foreach (XElement child in parent.Elements())
        {
            if (child.Name.LocalName == "geom")
            {
                yield return new MjcfGeom(child, _defaults.With(child, childClass), position, turn, _attributes);
            }
            else if (child.Name.LocalName == "frame")
            {
                Vector3d at = position + turn.Rotate(_attributes.Vector(child, "pos") ?? Vector3d.Zero);
                foreach (MjcfGeom geom in Geoms(child, child.Attribute("childclass")?.Value ?? childClass, at, turn * _turns.Of(child)))
                    yield return geom;
            }
        }
    }

    /// <summary>The geometry of a body with an inertial: colliding geoms, or visual ones where none collides.</summary>
    private Geometry? Looks(IReadOnlyList<MjcfGeom> geoms, List<string> notes)
    {
        Geometry all = new();
        bool collides = geoms.Any(geom => geom.Collides);
        foreach (MjcfGeom geom in geoms.Where(geom => geom.Collides == collides))
        {
            try
            {
                if (_geoms.Solid(geom) is (Shape shape, _, Vector3d position, Quaterniond turn))
                    all.Add(shape, position, turn);
            }
            catch (ArgumentException refused)
            {
                throw XmlFile.Wrong(_file, geom.Element, refused.Message);
            }
            catch (OmittedException missing)
            {
                notes.Add($"not compared with its geoms: {missing.Message}");
                return null;
            }
        }

        return all.Count > 0 ? all : null;
    }

    private IEnumerable<XElement> Settings() => _mujoco.Elements("compiler");

    // the last one counts
    private string Compiler(string name, string otherwise) => Settings().Select(element => element.Attribute(name)?.Value).LastOrDefault(value => value != null) ?? otherwise;
}
