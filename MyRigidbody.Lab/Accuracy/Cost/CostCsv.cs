using System.Globalization;
using System.Text;
using RigidBodyDynamics.Lab.Output;

namespace RigidBodyDynamics.Lab;

/// <summary>All trials as CSV: SI units and radians, except nanosecondsPerStep; Infinity where a run broke off.</summary>
internal static class CostCsv
{
    public const string Header =
        "scene,integrator,order,step,steps,angleError,positionError,energyDrift,momentumDrift,nanosecondsPerStep,secondsPerSimulatedSecond";

    /// <summary>One row for each trial.</summary>
    public static string Of(IEnumerable<CostFindings> found)
    {
        StringBuilder text = new(Header + "\n");
        foreach (CostFindings findings in found)
        {
            string scene = Csv.Cell(findings.Motion.Scene.Name);
            foreach (Trial t in findings.Trials)
            {
                text.Append(
                    CultureInfo.InvariantCulture,
                    $"{scene},{t.Rule.Name},{t.Rule.Order},{t.Step:R},{t.Steps},{t.AngleError:R},{t.PositionError:R},{t.EnergyDrift:R},{t.MomentumDrift:R},{t.NanosecondsPerStep:R},{t.Cost:R}\n");
            }
        }

        return text.ToString();
    }
}
