using System.Diagnostics;
using System.Text.Json;

namespace RigidBodyDynamics.Contacts;

/// <summary>PhysX in a process of Node's, one line a request and one an answer.</summary>
internal sealed class PhysX : IDisposable
{
    private static readonly JsonSerializerOptions Json = new(JsonSerializerDefaults.Web);
    private readonly Process _node;

    public PhysX(string engines)
    {
        ProcessStartInfo start = new("node", ["contacts.mjs"]) { WorkingDirectory = engines, RedirectStandardInput = true, RedirectStandardOutput = true };
        _node = Process.Start(start) ?? throw new InvalidOperationException("node did not start");
    }

    public string Name { get; private set; } = string.Empty;

    /// <summary>A new world; the principal moments of each body.</summary>
    public double[][] Begin(Setting setting)
    {
        JsonElement answer = Ask<JsonElement>(setting);
        Name = answer.GetProperty("name").GetString()!;
        return answer.GetProperty("inertia").Deserialize<double[][]>()!;
    }

    /// <summary>Sets angular velocities, adds torques and steps; fourteen numbers for each body.</summary>
    public double[][] Step(float step, IEnumerable<double[]> set, IEnumerable<double[]> torque) =>
        Ask<double[][]>(new { step = (double)step, set, torque });

    public void Dispose()
    {
        _node.StandardInput.Close();
        _node.WaitForExit();
        _node.Dispose();
    }

    private T Ask<T>(object request)
    {
        _node.StandardInput.WriteLine(JsonSerializer.Serialize(request, Json));
        _node.StandardInput.Flush();
        string answer = _node.StandardOutput.ReadLine() ?? throw new InvalidOperationException("tests/engines/contacts.mjs has ended");
        return JsonSerializer.Deserialize<T>(answer, Json)!;
    }
}
