using RigidBodyDynamics.Lab.Meshes;
using RigidBodyDynamics.Lab.Output;

namespace RigidBodyDynamics.Lab;

/// <summary>
/// A value of a scene file, as the tables of effects and of kinds of inertia describe it. One kind of form reads it; another, of the tests, writes the JSON
/// Schema, so that reader and schema have one source.
/// </summary>
internal abstract class Form
{
    /// <summary>A number; the object made from it refuses numbers out of its bounds.</summary>
    public abstract double Number(string about, double least = double.NegativeInfinity, double most = double.PositiveInfinity);

    /// <summary>[x, y, z].</summary>
    public abstract Vector3d Vector(string about);

    /// <summary>A number above zero.</summary>
    public abstract double Positive(string about);

    /// <summary>A list of numbers above zero, at least one.</summary>
    public abstract double[] Positives(string about);

    /// <summary>[x, y, z], all above zero.</summary>
    public abstract Vector3d Lengths(string about);

    /// <summary>[w, x, y, z].</summary>
    public abstract Quaterniond Turn(string about);

    /// <summary>A list of [x, y, z].</summary>
    public abstract Vector3d[] Vectors(string about, int least = 0);

    /// <summary>A list of parts of a body, at least one.</summary>
    public abstract T[] Parts<T>(string about, Func<Fields, T> read);

    /// <summary>An object made from a mesh; the value is the name of its file, beside the scene.</summary>
    public abstract T Mesh<T>(string about, Func<MeshFile, T> read);

    /// <summary>One of some words; returns its number.</summary>
    public abstract int OneOf(string about, params string[] words);

    /// <summary>An object with the fields that are read, and no other.</summary>
    public abstract T Object<T>(string about, Func<Form, T> read);

    public abstract T NumberOrObject<T>(string about, Func<Form, T> number, Func<Form, T> fields);

    /// <summary>[x, y, z] or an object.</summary>
    public abstract T VectorOrObject<T>(string about, Func<Form, T> vector, Func<Form, T> fields);

    /// <summary>A required field of this object.</summary>
    public abstract Form this[string field] { get; }

    /// <summary>An optional field of this object.</summary>
    public abstract T Or<T>(string field, T otherwise, Func<Form, T> read);

    /// <summary>[x, y, z] in an optional field; zero where it is absent.</summary>
    public Vector3d OptionalVector(string field, string about) => Or(field, Vector3d.Zero, vector => vector.Vector(about));

    /// <summary>The number of one of some words in an optional field; 0 where it is absent.</summary>
    public int OptionalOneOf(string field, string about, params string[] words) => Or(field, 0, word => word.OneOf(about, words));

    /// <summary>True if this object has an optional field.</summary>
    public abstract bool Has(string field);
}

/// <summary>A form that reads the value at a place.</summary>
internal sealed class FilledForm(Place place) : Form
{
    private Fields? _fields;

    /// <summary>A form that reads an object some of whose fields are already taken.</summary>
    public FilledForm(Fields fields) : this(fields.Place) => _fields = fields;

    private Fields Known => _fields ??= place.Fields();

    public override Form this[string field] => new FilledForm(Known.Required(field));

    public override double Number(string about, double least, double most) => place.Number();

    public override Vector3d Vector(string about) => place.Vector();

    public override double Positive(string about) => place.Number();

    public override double[] Positives(string about) => place.Numbers();

    public override Vector3d Lengths(string about) => place.Vector();

    public override Quaterniond Turn(string about) => place.Turn();

    public override Vector3d[] Vectors(string about, int least) => place.Items("a list of vectors", item => item.Vector());

    public override T[] Parts<T>(string about, Func<Fields, T> read)
    {
        T[] parts = place.Items("a list of parts", item =>
        {
            Fields part = item.Fields();
            T made = read(part);
            part.End();
            return made;
        });
        return parts.Length > 0 ? parts : throw place.Wrong("must have at least one part");
    }

    public override T Mesh<T>(string about, Func<MeshFile, T> read)
    {
        string name = place.Text(), path = Path.Combine(Path.GetDirectoryName(Path.GetFullPath(place.File)) ?? string.Empty, name);
        try
        {
            return read((place.Above ?? Known).Meshes.Read(path));
        }
        catch (InputException wrong)
        {
            // the file as named in the scene, and the place of that name
            throw place.Wrong(wrong.Message.Replace(path, name, StringComparison.Ordinal));
        }
    }

    public override int OneOf(string about, params string[] words) => place.OneOf(words);

    public override T Object<T>(string about, Func<Form, T> read)
    {
        _ = Known;
        T made = read(this);
        Known.End();
        return made;
    }

    public override T NumberOrObject<T>(string about, Func<Form, T> number, Func<Form, T> fields) => place.Value.ValueKind switch
    {
        System.Text.Json.JsonValueKind.Number => number(this),
        System.Text.Json.JsonValueKind.Object => Object(about, fields),
        _ => throw place.Not("a number or an object { … }"),
    };

    public override T VectorOrObject<T>(string about, Func<Form, T> vector, Func<Form, T> fields) => place.Value.ValueKind switch
    {
        System.Text.Json.JsonValueKind.Array => vector(this),
        System.Text.Json.JsonValueKind.Object => Object(about, fields),
        _ => throw place.Not("three numbers [x, y, z] or an object { … }"),
    };

    public override T Or<T>(string field, T otherwise, Func<Form, T> read) =>
        Known.Or(field, otherwise, value => read(new FilledForm(value)));

    public override bool Has(string field) => Known.Optional(field) != null;
}
