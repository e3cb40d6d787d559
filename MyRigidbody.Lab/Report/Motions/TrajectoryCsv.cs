using System.Buffers;
using System.Globalization;
using System.Text;
using RigidBodyDynamics.Lab.Output;

namespace RigidBodyDynamics.Lab.Report;

/// <summary>The trajectory as CSV: one row for each body and step, with numbers that read back to the same bits.</summary>
/// <remarks>Formatting numbers costs more than the motion, so rows are collected and formatted on all processors.</remarks>
internal sealed class TrajectoryCsv(Stream stream) : IDisposable
{
    private const int RowsOfPiece = 64, Pieces = 16, LongestNumber = 32;

    private readonly Dictionary<string, byte[]> _names = [];
    private readonly Row[] _rows = new Row[Pieces * RowsOfPiece];
    private readonly ArrayBufferWriter<byte>[] _pieces = [.. Enumerable.Range(0, Pieces).Select(_ => new ArrayBufferWriter<byte>())];
    private int _count;

    /// <summary>All bodies of a simulation, at the start and after every step, into a file.</summary>
    public static void Write(Simulation simulation, string path, string to)
    {
        using FileStream file = new(to, FileMode.Create);
        using TrajectoryCsv csv = new(file);
        csv.WriteHeader();
        RunAway.MustBeFinite(simulation, path);
        csv.WriteRows(simulation);
        while (simulation.StepsDone < simulation.Scene.Steps.Count)
        {
            simulation.Step();
            RunAway.MustBeFinite(simulation, path);
            csv.WriteRows(simulation);
        }
    }

    public void WriteHeader() => stream.Write("body,step,t,px,py,pz,qw,qx,qy,qz,vx,vy,vz,wx,wy,wz,Lx,Ly,Lz,kineticEnergy,asleep\n"u8);

    /// <summary>One row for every body, with its present state.</summary>
    public void WriteRows(Simulation simulation)
    {
        foreach (Body body in simulation.Bodies)
        {
            if (_count == _rows.Length)
                WriteCollected();

            _rows[_count++] = new Row(body, CellOf(body), simulation.StepsDone, simulation.Time, body.State, body.IsAsleep);
        }
    }

    /// <summary>Writes all rows collected so far.</summary>
    public void Flush()
    {
        WriteCollected();
        stream.Flush();
    }

    /// <summary>Writes all rows collected so far.</summary>
    public void Dispose() => WriteCollected();

    /// <summary>Cells of many numbered bodies are not stored.</summary>
    private byte[]? CellOf(Body body)
    {
        if (body.Tag != null)
            return null;

        if (!_names.TryGetValue(body.Name, out byte[]? cell))
            _names[body.Name] = cell = Cell(body);

        return cell;
    }

    private static byte[] Cell(Body body) => Encoding.UTF8.GetBytes(Csv.Cell(ManyBodies.NameOf(body)));

    private void WriteCollected()
    {
        int count = _count, pieces = (count + RowsOfPiece - 1) / RowsOfPiece;
        _count = 0;
        if (pieces < 2)
            Format(0, count);
        else
            Parallel.For(0, pieces, piece => Format(piece, count));

        foreach (ArrayBufferWriter<byte> piece in _pieces)
        {
            stream.Write(piece.WrittenSpan);
            piece.ResetWrittenCount();
        }
    }

    private void Format(int piece, int count)
    {
        for (int i = piece * RowsOfPiece; i < Math.Min(count, (piece + 1) * RowsOfPiece); i++)
            Write(_pieces[piece], _rows[i]);
    }

    private static void Write(ArrayBufferWriter<byte> to, in Row row)
    {
        MassProperties mass = row.Body.Mass;
        BodyState state = row.State;
        to.Write(row.Cell ?? Cell(row.Body));
        Write(to, row.Step);
        Write(to, row.Time);
        Write(to, state.Position);
        Write(to, state.Orientation.W);
        Write(to, state.Orientation.Vector);
        Write(to, state.Velocity);
        Write(to, state.AngularVelocity);
        Write(to, Conserved.AngularMomentum(state, mass));
        Write(to, Conserved.KineticEnergy(state, mass));
        to.Write(row.IsAsleep ? ",1\n"u8 : ",0\n"u8);
    }

    private static void Write(ArrayBufferWriter<byte> to, Vector3d vector)
    {
        Write(to, vector.X);
        Write(to, vector.Y);
        Write(to, vector.Z);
    }

    private static void Write<T>(ArrayBufferWriter<byte> to, T number)
        where T : struct, IUtf8SpanFormattable
    {
        Span<byte> free = to.GetSpan(LongestNumber);
        free[0] = (byte)',';
        _ = number.TryFormat(free[1..], out int length, default, CultureInfo.InvariantCulture);
        to.Advance(length + 1);
    }

    private readonly record struct Row(Body Body, byte[]? Cell, long Step, double Time, BodyState State, bool IsAsleep);
}
