using RigidBodyDynamics.Lab.Output;

namespace RigidBodyDynamics.Lab.Report;

/// <summary>The integration of a body has diverged: later states are meaningless, and no file contains them.</summary>
internal static class RunAway
{
    public static void MustBeFinite(Simulation simulation, string path)
    {
        foreach (Body body in simulation.Bodies)
        {
            BodyState state = body.State;
            if (!Guard.IsFinite(Conserved.KineticEnergy(state, body.Mass)) || !Conserved.AngularMomentum(state, body.Mass).IsFinite)
            {
                throw new FellShortException(
                    $"{path}: body {ManyBodies.NameOf(body)}: {body.Rule.Name} has diverged: no finite energy or angular momentum after step {simulation.StepsDone}");
            }
        }
    }
}
