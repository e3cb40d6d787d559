using System.Xml.Linq;

namespace RigidBodyDynamics.Lab.Inertia.Robots;

/// <summary>The default classes of an MJCF for geoms and meshes. A class inherits from those above it.</summary>
internal sealed class MjcfDefaults
{
    private readonly Dictionary<string, Dictionary<string, XElement>> _classes = [];
    private readonly string _main = "main";

    public MjcfDefaults(XElement mujoco)
    {
        foreach (XElement top in mujoco.Elements("default"))
        {
            _main = top.Attribute("class")?.Value ?? _main;
            Read(top, _classes.GetValueOrDefault(_main) ?? [], _main);
        }
    }

    /// <summary>An element with all attributes that apply to it.</summary>
    public XElement With(XElement element, string? childClass = null)
    {
        string name = element.Attribute("class")?.Value ?? childClass ?? _main;
        return _classes.TryGetValue(name, out Dictionary<string, XElement>? known) && known.TryGetValue(element.Name.LocalName, out XElement? above)
            ? Over(above, element)
            : element;
    }

    private void Read(XElement of, Dictionary<string, XElement> inherited, string name)
    {
        Dictionary<string, XElement> own = new(inherited);
        foreach (XElement element in of.Elements().Where(element => element.Name.LocalName is "geom" or "mesh"))
        {
            string kind = element.Name.LocalName;
            own[kind] = own.TryGetValue(kind, out XElement? above) ? Over(above, element) : element;
        }

        _classes[name] = own;
        foreach (XElement inner in of.Elements("default"))
            Read(inner, own, inner.Attribute("class")?.Value ?? string.Empty);
    }

    private static XElement Over(XElement below, XElement above)
    {
        XElement both = new(above.Name, above.Attributes().Select(attribute => new XAttribute(attribute)));
        // any attribute of orientation replaces the inherited one
        bool isTurned = above.Attributes().Any(attribute => MjcfTurns.Names.Contains(attribute.Name.LocalName));
        foreach (XAttribute attribute in below.Attributes())
        {
            if (both.Attribute(attribute.Name) == null && !(isTurned && MjcfTurns.Names.Contains(attribute.Name.LocalName)))
                both.Add(new XAttribute(attribute));
        }

        return both;
    }
}
