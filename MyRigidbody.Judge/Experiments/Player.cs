using System.Collections.Generic;
using System.Linq;

namespace RigidBodyDynamics.Judging
{
    /// <summary>Plays one experiment and records the script's variables before and after each frame.</summary>
    internal sealed class Player
    {
        private readonly Bench _bench;
        private readonly IReadOnlyDictionary<Role, string> _roles;
        private Dictionary<Role, Variable> _variables;

        public Player(Bench bench, IReadOnlyDictionary<Role, string> roles)
        {
            _bench = bench;
            _roles = roles;
        }

        /// <summary>Plays the moves on a new object, whose mass is that of the script times <paramref name="massFactor"/>.</summary>
        public Run Play(string name, Setting setting, double massFactor, IEnumerable<Move> moves)
        {
            _bench.KeyAsked = null;
            _bench.Begin(setting);
            MultiplyMass(massFactor);
            _bench.Start();
            _variables = Assigned();
            Matrix? inertia = Find(Role.Inertia)?.Matrix;
            if (inertia.HasValue && !setting.Equals(Settings.Cube))
                ReplaceInertia(inertia.Value, setting);
            List<Frame> frames = new List<Frame>();
            double time = 0;
            Snapshot before = Look();
            foreach (Move move in moves)
            {
                time += move.Delta;
                frames.Add(Play(move, new FrameInput(frames.Count + 1, time, move.Delta, move.Held), before));
                before = frames[frames.Count - 1].After;
            }

            return new Run(name, setting, inertia, frames);
        }

        private Frame Play(Move move, FrameInput input, Snapshot before)
        {
            if (move.State != null)
            {
                Set(move.State);
                before = Look();
            }

            Vector? force = Find(Role.Force) == null ? null : move.Force, torque = Find(Role.Torque) == null ? null : move.Torque;
            _bench.KeyAsked = force == null && torque == null ? null : new System.Action<Keys>(_ =>
            {
                if (force.HasValue)
                    Find(Role.Force).Vector = force.Value;
                if (torque.HasValue)
                    Find(Role.Torque).Vector = torque.Value;
            });
            _bench.Frame(input);
            return new Frame(input, before, Look(), move.State != null, force, torque);
        }

        /// <summary>As in the inspector, before Start; a script that sets its mass in Start keeps its own.</summary>
        private void MultiplyMass(double factor)
        {
            _variables = Assigned();
            Variable mass = Find(Role.Mass);
            if (mass != null)
                mass.Write(new[] { mass.Number * factor });
        }

        /// <summary>A script with the cube's corners as constants has the cube's I_ref for every box; it gets that of the box.</summary>
        private void ReplaceInertia(Matrix found, Setting setting)
        {
            Matrix cube = Matrix.InertiaOf(Settings.Cube.Vertices), box = Matrix.InertiaOf(setting.Vertices);
            if (found.Size > 0 && ((1 / found.Size) * found - (1 / cube.Size) * cube).Size < 1e-3)
                Find(Role.Inertia).Matrix = (found.Size / cube.Size) * box;
        }

        private void Set(State state)
        {
            _bench.Pose = new Pose(state.Position, state.Orientation);
            Write(Role.Position, state.Position);
            Write(Role.Velocity, state.Velocity);
            Write(Role.AngularVelocity, state.AngularVelocity);
            Variable own = Find(Role.Orientation);
            if (own != null)
                own.Orientation = state.Orientation;
        }

        private void Write(Role role, Vector value)
        {
            Variable variable = Find(role);
            if (variable != null)
                variable.Vector = value;
        }

        private Snapshot Look()
        {
            Pose pose = _bench.Pose;
            return new Snapshot
            {
                Position = pose.Position,
                Orientation = pose.Orientation,
                OwnOrientation = Find(Role.Orientation)?.Orientation,
                Velocity = Find(Role.Velocity)?.Vector,
                AngularVelocity = Find(Role.AngularVelocity)?.Vector,
                Force = Find(Role.Force)?.Vector,
                Torque = Find(Role.Torque)?.Vector,
                Mass = Find(Role.Mass)?.Number,
                Inertia = Find(Role.Inertia)?.Matrix,
            };
        }

        private Dictionary<Role, Variable> Assigned()
        {
            Dictionary<Role, Variable> assigned = new Dictionary<Role, Variable>();
            foreach (KeyValuePair<Role, string> role in _roles)
            {
                bool isScalarFirst = role.Value.StartsWith(Variable.ScalarFirstPrefix, System.StringComparison.Ordinal);
                string name = isScalarFirst ? role.Value.Substring(Variable.ScalarFirstPrefix.Length) : role.Value;
                Variable variable = _bench.Variables.FirstOrDefault(v => v.Name == name && v.Shape == RoleNames.ShapeOf(role.Key));
                if (variable != null)
                    assigned[role.Key] = isScalarFirst ? variable.ScalarFirst() : variable;
            }

            return assigned;
        }

        private Variable Find(Role role) => _variables.TryGetValue(role, out Variable variable) ? variable : null;
    }
}
