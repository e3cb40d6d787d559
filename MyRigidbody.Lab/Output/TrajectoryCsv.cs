using System.Globalization;

namespace RigidBodyDynamics.Lab.Output;

/// <summary>The trajectory as CSV: a row a body and step, numbers that read back to the same bits.</summary>
internal sealed class TrajectoryCsv(TextWriter writer)
{
    private const string Header =
        "body,step,t,px,py,pz,qw,qx,qy,qz,vx,vy,vz,wx,wy,wz,Lx,Ly,Lz,kineticEnergy,asleep";

    /// <summary>The first line.</summary>
    public void WriteHeader()
    {
        writer.Write(Header);
        writer.Write('\n');
    }

    /// <summary>A row for every body, as it is now.</summary>
    public void WriteRows(Simulation simulation)
    {
        foreach (Body body in simulation.Bodies)
        {
            WriteRow(ManyBodies.NameOf(body), simulation.StepsDone, simulation.Time, body.State, body.Mass, body.IsAsleep);
        }
    }

    /// <summary>A row.</summary>
    public void WriteRow(string body, long step, double time, in BodyState state, MassProperties mass, bool isAsleep)
    {
        writer.Write(Csv.Cell(body));
        writer.Write(',');
        writer.Write(step.ToString(CultureInfo.InvariantCulture));
        Write(time);
        Write(state.Position);
        Write(state.Orientation.W);
        Write(state.Orientation.Vector);
        Write(state.Velocity);
        Write(state.AngularVelocity);
        Write(Conserved.AngularMomentum(state, mass));
        Write(Conserved.KineticEnergy(state, mass));
        writer.Write(isAsleep ? ",1\n" : ",0\n");
    }

    private void Write(Vector3d vector)
    {
        Write(vector.X);
        Write(vector.Y);
        Write(vector.Z);
    }

    private void Write(double number)
    {
        writer.Write(',');
        writer.Write(number.ToString("R", CultureInfo.InvariantCulture));
    }
}
