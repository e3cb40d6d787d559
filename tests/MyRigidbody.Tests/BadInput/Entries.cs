using System.Reflection;

namespace RigidBodyDynamics.Tests;

/// <summary>A public constructor, method or setter of the library that takes something.</summary>
internal sealed record Entry(Type Type, MethodBase Method)
{
    private const BindingFlags Declared = BindingFlags.Public | BindingFlags.Static | BindingFlags.Instance | BindingFlags.DeclaredOnly;

    // what a generic type or method is tried with
    private static readonly Dictionary<string, Type> Arguments = new()
    {
        ["TIntegrator"] = typeof(MomentumEuler),
        ["TPush"] = typeof(HeldKeys),
    };

    /// <summary>All of them, including future ones.</summary>
    public static IReadOnlyList<Entry> All { get; } =
    [
        .. from type in typeof(Simulation).Assembly.GetExportedTypes()
           where !type.IsInterface && !type.IsEnum && !typeof(Delegate).IsAssignableFrom(type)
           let closed = type.IsGenericTypeDefinition ? type.MakeGenericType(Closed(type.GetGenericArguments())) : type
           from method in closed.GetMethods(Declared).Cast<MethodBase>().Concat(closed.GetConstructors(Declared))
           where method.GetParameters().Length > 0 && !(method is MethodInfo overriding && overriding.GetBaseDefinition().DeclaringType != closed)
           select new Entry(closed, method is MethodInfo { IsGenericMethodDefinition: true } generic ? generic.MakeGenericMethod(Closed(generic.GetGenericArguments())) : method),
    ];

    /// <inheritdoc/>
    public override string ToString() =>
        $"{Type.Name.Split('`')[0]}.{Method.Name}({string.Join(", ", Method.GetParameters().Select(parameter => Plain(parameter).Name.Split('`')[0]))})";

    /// <summary>Type of what is passed, by reference or not.</summary>
    public static Type Plain(ParameterInfo parameter) =>
        parameter.ParameterType.IsByRef ? parameter.ParameterType.GetElementType()! : parameter.ParameterType;

    /// <summary>Calls it with sound arguments but for one; returns what comes out, by reference too.</summary>
    public object?[] Call(int hostileAt, object? hostile)
    {
        ParameterInfo[] parameters = Method.GetParameters();
        object?[] arguments = [.. parameters.Select((parameter, i) => i == hostileAt ? hostile : Values.Sound(Plain(parameter)))];
        object? target = Method.IsStatic || Method.IsConstructor ? null : Values.Sound(Type);
        object? result = Method is ConstructorInfo constructor
            ? constructor.Invoke(BindingFlags.DoNotWrapExceptions, null, arguments, null)
            : Method.Invoke(target, BindingFlags.DoNotWrapExceptions, null, arguments, null);
        return [result, .. arguments.Where((_, i) => parameters[i].ParameterType.IsByRef && !parameters[i].IsIn)];
    }

    private static Type[] Closed(Type[] parameters) => [.. parameters.Select(parameter => Arguments[parameter.Name])];
}
