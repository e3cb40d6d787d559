using System;
using System.Collections.Generic;
using System.Linq;

namespace RigidBodyDynamics.Judging
{
    /// <summary>
    /// Finds which variable of a script is its velocity, its torque and so on: by its name, and by its behaviour. A variable that moves
    /// the object when it is changed is the velocity, whatever its name.
    /// </summary>
    internal sealed class RoleFinder
    {
        private static readonly Vector Probe = new Vector(1.1, -0.7, 0.9);

        private readonly Bench _bench;

        public RoleFinder(Bench bench) => _bench = bench;

        public IReadOnlyDictionary<Role, string> Find()
        {
            Dictionary<Role, string> roles = new Dictionary<Role, string>();
            _bench.Begin(Settings.TurnedBox);
            _bench.Start();
            IReadOnlyList<Variable> variables = _bench.Variables;
            Pose here = _bench.Pose;
            Take(roles, Role.Mass, RoleNames.Candidates(Role.Mass, variables).FirstOrDefault());
            Take(roles, Role.Inertia, Inertia(variables));
            Take(roles, Role.Orientation, OwnOrientation(variables, here));
            Take(roles, Role.Force, Shown(Role.Force, variables, Keys.RightArrow | Keys.UpArrow, new Vector(5, 5, 0)));
            double sine = Math.Sin(1);
            Take(roles, Role.Torque, Shown(Role.Torque, variables, Keys.R, new Vector(sine, sine, sine)));
            FindMoving(roles, variables);
            return roles;
        }

        private static void Take(Dictionary<Role, string> roles, Role role, Variable variable)
        {
            if (variable != null)
                roles[role] = variable.Name;
        }

        /// <summary>The variable with the expected value after a frame with the keys; by name where none has it, or several.</summary>
        private Variable Shown(Role role, IReadOnlyList<Variable> variables, Keys keys, Vector value)
        {
            _bench.Begin(Settings.TurnedBox);
            _bench.Start();
            _bench.Frame(new FrameInput(1, 1, FrameInput.FixedDelta, keys));
            HashSet<string> holding = new HashSet<string>(_bench.Variables
                .Where(v => v.Shape == Shape.Vector && (v.Vector - value).Length < 1e-4).Select(v => v.Name));
            IReadOnlyList<Variable> named = RoleNames.Candidates(role, variables);
            return named.FirstOrDefault(v => holding.Contains(v.Name)) ?? named.FirstOrDefault()
                ?? variables.FirstOrDefault(v => holding.Contains(v.Name) && !RoleNames.IsAnother(role, v.Name));
        }

        /// <summary>By its value after Start, I_ref or its inverse; else by its name.</summary>
        private static Variable Inertia(IReadOnlyList<Variable> variables)
        {
            Variable[] matrices = variables.Where(v => v.Shape == Shape.Matrix && v.Matrix.IsFinite).ToArray();
            IReadOnlyList<Variable> named = RoleNames.Candidates(Role.Inertia, matrices);
            Matrix box = Matrix.InertiaOf(Settings.TurnedBox.Vertices);
            return named.Concat(matrices).FirstOrDefault(v => IsInProportion(v.Matrix, box)) ?? named.FirstOrDefault()
                ?? matrices.FirstOrDefault(v => IsInProportion(v.Matrix, box.Inverse));
        }

        private static bool IsInProportion(Matrix a, Matrix b) =>
            a.Size > 0 && ((1 / a.Size) * a - (1 / b.Size) * b).Size < 1e-3;

        /// <summary>A quaternion of the script's own that rotates the object: it equals the orientation after Start, or is found by name.</summary>
        private static Variable OwnOrientation(IReadOnlyList<Variable> variables, Pose here)
        {
            List<Variable> own = variables.Where(v => v.Shape == Shape.Quaternion).ToList();
            IReadOnlyList<Variable> named = RoleNames.Candidates(Role.Orientation, own);
            foreach (Variable v in named.Concat(own))
            {
                if (Orientation.Angle(v.Orientation, here.Orientation) < 1e-3)
                    return v;
                if (Orientation.Angle(v.ScalarFirst().Orientation, here.Orientation) < 1e-3)
                    return v.ScalarFirst();
            }

            return named.FirstOrDefault();
        }

        /// <summary>The velocity, the angular velocity and the script's own position: found by the object's reaction when each vector is changed.</summary>
        private void FindMoving(Dictionary<Role, string> roles, IReadOnlyList<Variable> variables)
        {
            Pose still = Played(null);
            List<string> moves = new List<string>(), turns = new List<string>(), places = new List<string>();
            foreach (Variable v in variables.Where(v => v.Shape == Shape.Vector && !roles.ContainsValue(v.Name)))
            {
                Pose changed = Played(v.Name);
                if ((changed.Position - Probe).Length < 0.3 && (still.Position - Probe).Length > 0.5)
                    places.Add(v.Name);
                else if (!((changed.Position - still.Position).Length < 1e-5))
                    moves.Add(v.Name);
                if (!(Orientation.Angle(changed.Orientation, still.Orientation) < 1e-5))
                    turns.Add(v.Name);
            }

            Take(roles, Role.Velocity, Best(Role.Velocity, variables, moves));
            Take(roles, Role.AngularVelocity, Best(Role.AngularVelocity, variables, turns));
            Take(roles, Role.Position, variables.FirstOrDefault(v => places.Contains(v.Name) && !RoleNames.IsAnother(Role.Position, v.Name)));
        }

        private static Variable Best(Role role, IReadOnlyList<Variable> variables, IReadOnlyCollection<string> acting)
        {
            IReadOnlyList<Variable> named = RoleNames.Candidates(role, variables);
            return named.FirstOrDefault(v => acting.Contains(v.Name))
                ?? named.FirstOrDefault()
                ?? variables.FirstOrDefault(v => acting.Contains(v.Name) && !RoleNames.IsAnother(role, v.Name))
                ?? variables.FirstOrDefault(v => acting.Contains(v.Name));
        }

        private Pose Played(string changed)
        {
            _bench.Begin(Settings.TurnedBox);
            _bench.Start();
            Variable variable = _bench.Variables.FirstOrDefault(v => v.Name == changed);
            if (variable != null)
                variable.Vector = Probe;
            _bench.Frame(new FrameInput(1, 1, FrameInput.FixedDelta, Keys.None));
            return _bench.Pose;
        }
    }
}
