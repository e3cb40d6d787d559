namespace RigidBodyDynamics.Lab;

/// <summary>
/// A value of a scene file, as the table of effects says what it is. One kind of form reads it; another, of the tests, writes the JSON Schema,
/// so that what is read and what an editor is told are said once.
/// </summary>
internal abstract class Form
{
    /// <summary>A number; its bounds are refused by what is made of it.</summary>
    public abstract double Number(string about, double least = double.NegativeInfinity, double most = double.PositiveInfinity);

    /// <summary>[x, y, z].</summary>
    public abstract Vector3d Vector(string about);

    /// <summary>A list of [x, y, z].</summary>
    public abstract Vector3d[] Vectors(string about);

    /// <summary>One of some words; returns its number.</summary>
    public abstract int OneOf(string about, params string[] words);

    /// <summary>An object that has the fields which are read of it, and no other.</summary>
    public abstract T Object<T>(string about, Func<Form, T> read);

    /// <summary>A number or an object.</summary>
    public abstract T NumberOrObject<T>(string about, Func<Form, T> number, Func<Form, T> fields);

    /// <summary>A field of this object that must be there.</summary>
    public abstract Form this[string field] { get; }

    /// <summary>A field of this object that may be there.</summary>
    public abstract T Or<T>(string field, T otherwise, Func<Form, T> read);
}

/// <summary>A form that reads what stands at a place.</summary>
internal sealed class FilledForm(Place place) : Form
{
    private Fields? _fields;

    private Fields Known => _fields ??= place.Fields();

    public override Form this[string field] => new FilledForm(Known.Required(field));

    public override double Number(string about, double least, double most) => place.Number();

    public override Vector3d Vector(string about) => place.Vector();

    public override Vector3d[] Vectors(string about) => place.Items("a list of vectors", item => item.Vector());

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

    public override T Or<T>(string field, T otherwise, Func<Form, T> read) =>
        Known.Or(field, otherwise, value => read(new FilledForm(value)));
}
