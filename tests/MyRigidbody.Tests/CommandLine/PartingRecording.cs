using System.Text.Json.Nodes;

namespace RigidBodyDynamics.Tests.CommandLine;

/// <summary>A recording whose body, near its unstable axis, had a push at one step that its list of pushes does not contain.</summary>
internal static class PartingRecording
{
    /// <summary>The first row that differs.</summary>
    public const int PartsAt = 1659;

    /// <summary>Writes it into the folder; returns the path of its JSON file.</summary>
    public static string In(TemporaryFolder folder)
    {
        JsonNode recording = JsonNode.Parse(File.ReadAllText(TestData.Physx("d_intermediate_gyro_on.json")))!;
        recording["torque"]![3 * (PartsAt - 1)] = 1e-5;
        string path = folder.File("parting.json");
        File.WriteAllText(path, recording.ToJsonString());
        File.Copy(TestData.Physx("d_intermediate_gyro_on.csv"), folder.File("parting.csv"));
        return path;
    }
}
