using System.Text.Json;
using RigidBodyDynamics.Lab.Meshes;

namespace RigidBodyDynamics.Lab;

/// <summary>The fields of a JSON object. Each is taken by name; a field that is not taken is unknown and refused.</summary>
internal sealed class Fields
{
    private readonly List<string> _known = [];
    private readonly (string Name, JsonElement Value)[] _all;
    private MeshShelf? _meshes;

    /// <summary>The fields of an object.</summary>
    public Fields(Place place)
    {
        Place = place.Value.ValueKind == JsonValueKind.Object ? place : throw place.Not("an object { … }");
        // copied once, because a search in the document takes ten times as long
        _all = new (string, JsonElement)[place.Value.GetPropertyCount()];
        int i = 0;
        foreach (JsonProperty field in place.Value.EnumerateObject())
            _all[i++] = (field.Name, field.Value);
    }

    /// <summary>The place of the object.</summary>
    public Place Place { get; }

    /// <summary>The meshes of the whole file.</summary>
    public MeshShelf Meshes => Place.Above is Fields above ? above.Meshes : _meshes ??= new MeshShelf();

    /// <summary>A required field.</summary>
    public Place Required(string name) => Optional(name) ?? throw Place.Wrong($"\"{name}\" is missing");

    /// <summary>An optional field.</summary>
    public Place? Optional(string name)
    {
        _known.Add(name);
        foreach ((string Name, JsonElement Value) field in _all)
        {
            if (field.Name == name)
                return At(name, field.Value);
        }

        return null;
    }

    /// <summary>The value of a field, or a default.</summary>
    public T Or<T>(string name, T otherwise, Func<Place, T> read) => Optional(name) is Place place ? read(place) : otherwise;

    /// <summary>A field that is optional under a condition, and refused otherwise.</summary>
    public Place? OnlyIf(bool condition, string name, string why)
    {
        Place? field = Optional(name);
        return field == null || condition ? field : throw field.Value.Wrong(why);
    }

    /// <summary>The fields that have not been taken yet.</summary>
    public IReadOnlyList<(string Name, Place Place)> Rest() =>
        [.. _all.Where(field => !_known.Contains(field.Name)).Select(field => (field.Name, At(field.Name, field.Value)))];

    /// <summary>Refuses any field that has not been taken.</summary>
    /// <param name="alsoKnown">Names that are possible here, in addition to those that were read.</param>
    public void End(params IEnumerable<string> alsoKnown)
    {
        foreach ((string name, JsonElement value) in _all)
        {
            if (!_known.Contains(name))
                throw At(name, value).Wrong("is not a name known here; known are " + string.Join(", ", _known.Concat(alsoKnown).Distinct()));
        }
    }

    private Place At(string name, JsonElement value) => new(Place.File, this, name, value);
}
