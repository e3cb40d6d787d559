using System;
using System.Collections.Generic;
using System.Linq;

namespace RigidBodyDynamics.Judging
{
    /// <summary>One velocity through all frames, with one reading of the gain.</summary>
    internal sealed class Links
    {
        private readonly Lazy<Link[]> _all;

        /// <param name="number">The number of the reading, the same for any choice of frames.</param>
        /// <param name="source">The source of the force or the torque.</param>
        /// <param name="frames">The velocity before and after each frame.</param>
        /// <param name="gain">The gain of velocity in a second, in the frame with this index.</param>
        /// <param name="code">What an instructor has to decide about the gain; null: it is the sheet's.</param>
        public Links(int number, Source source, VelocityFrames frames, Func<int, Vector> gain, string code = null)
        {
            Number = number;
            Source = source;
            Code = code;
            Unpushed = frames.Matches;
            _all = new Lazy<Link[]>(() => frames.Links.Select((link, i) => link.With(gain(i))).ToArray());
        }

        public int Number { get; }

        public Source Source { get; }

        public string Code { get; }

        public Link[] All => _all.Value;

        /// <summary>The matches of the frames without forces: no reading, time step or order makes a difference there.</summary>
        public Match[] Unpushed { get; }
    }

    /// <summary>One velocity through all frames, without a reading of its gain.</summary>
    internal sealed class VelocityFrames
    {
        public VelocityFrames(IEnumerable<Observation> frames, Func<Snapshot, Vector?> velocity)
        {
            At = frames.Where(o => velocity(o.Before).HasValue && velocity(o.After).HasValue).ToArray();
            Links = Array.ConvertAll(At, o => new Link(o, velocity(o.Before).Value, velocity(o.After).Value, Vector.Zero));
            Matches = Array.ConvertAll(Links, link => new Match(link, 0, Order.GainThenDecay));
            GainsNothing = Links.All(link => !link.At.IsVaried || Vector.Cross(link.Before, link.After).Length <= link.Tolerance(0) * link.Before.Length);
        }

        public Observation[] At { get; }

        public Link[] Links { get; }

        public Match[] Matches { get; }

        /// <summary>True if the velocity keeps its direction under any force: no reading of its gain is better than another.</summary>
        public bool GainsNothing { get; }
    }

    /// <summary>Every admissible reading of the gain of one velocity, the most likely first.</summary>
    internal sealed class GainReadings
    {
        private readonly Func<IEnumerable<int>> _different;
        private readonly bool _isOneEnough;

        /// <param name="all">The readings, by their numbers.</param>
        /// <param name="different">The numbers of those that are not the same as an earlier one in every frame.</param>
        /// <param name="isOneEnough">True if no reading is better than another.</param>
        public GainReadings(IReadOnlyList<Links> all, Func<IEnumerable<int>> different, bool isOneEnough)
        {
            All = all;
            _different = different;
            _isOneEnough = isOneEnough;
        }

        public IReadOnlyList<Links> All { get; }

        public IEnumerable<Links> ToTry => _isOneEnough ? All.Take(1) : _different().Select(number => All[number]);
    }
}
