using System;
using System.Collections.Generic;
using System.Linq;

namespace RigidBodyDynamics.Judging
{
    /// <summary>
    /// The experiments with a script. The lab's own scene hides mistakes: the inertia of a cube is the same about all axes, and the torque
    /// is always along (1, 1, 1). So there is a rotated box, too, and states, forces and torques are set anew every few frames.
    /// </summary>
    public static class Experiments
    {
        /// <summary>Plays all experiments; an exception of the script is thrown on.</summary>
        public static Recording Record(ILaboratory laboratory)
        {
            Bench bench = new Bench(laboratory);
            IReadOnlyDictionary<Role, string> roles = new RoleFinder(bench).Find();
            Player player = new Player(bench, roles);
            List<Run> runs = new List<Run>
            {
                player.Play("lab", Settings.Cube, 1, Keyboard(1, 3000)),
                player.Play("box", Settings.TurnedBox, 1, Keyboard(2, 600)),
                player.Play("states", Settings.TurnedBox, 2, States(3, 480, _ => FrameInput.FixedDelta)),
                player.Play("frame rates", Settings.TurnedBox, 1, States(4, 320, random => 1.0 / (30 + 15 * random.Next(5)))),
            };
            return new Recording(runs, roles.ToDictionary(r => r.Key.ToString(), r => r.Value.Replace(Variable.ScalarFirstPrefix, "")));
        }

        /// <summary>Simulated key presses: at rest at first, then one key, then any keys.</summary>
        private static IEnumerable<Move> Keyboard(int seed, int frames)
        {
            Keys[] first = { Keys.None, Keys.RightArrow, Keys.None, Keys.R, Keys.RightArrow | Keys.R, Keys.UpArrow, Keys.LeftArrow, Keys.None, Keys.DownArrow };
            Random random = new Random(seed);
            for (int i = 0, held = 0; i < frames; held++)
            {
                Keys keys = held < first.Length ? first[held] : (Keys)random.Next(32);
                for (int n = held == 0 ? 10 : 20 + random.Next(50); n > 0 && i < frames; n--, i++)
                    yield return new Move { Held = keys };
            }
        }

        /// <summary>A new state, and new keys or a given force and torque, every four frames.</summary>
        private static IEnumerable<Move> States(int seed, int frames, Func<Random, double> delta)
        {
            Random random = new Random(seed);
            for (int i = 0; i < frames; i += 4)
            {
                Keys keys = i % 3 == 0 ? (Keys)random.Next(32) : i % 8 == 0 ? Keys.R : Keys.None;
                bool ours = i % 3 == 1;
                Vector? force = ours ? Any(random, 5) : (Vector?)null, torque = ours ? Any(random, 2) : (Vector?)null;
                State state = new State(Any(random, 2), Turn(random), Any(random, 3), Any(random, 4));
                for (int n = 0; n < 4; n++)
                    yield return new Move { Delta = delta(random), Held = keys, State = n == 0 ? state : null, Force = force, Torque = torque };
            }
        }

        private static Vector Any(Random random, double size) => size * new Vector(Coordinate(random), Coordinate(random), Coordinate(random));

        private static Orientation Turn(Random random) =>
            new Orientation(Coordinate(random), Coordinate(random), Coordinate(random), Coordinate(random)).Normalized;

        private static double Coordinate(Random random) => 2 * random.NextDouble() - 1;
    }
}
