using System;
using System.Collections.Generic;
using System.Linq;

namespace RigidBodyDynamics.Judging
{
    /// <summary>One velocity through all frames, with the gain read in one way.</summary>
    internal sealed class Links
    {
        private readonly Lazy<Link[]> _all;

        /// <param name="number">Of the reading: the same in any choice of frames.</param>
        /// <param name="source">Where the force or the torque is taken from.</param>
        /// <param name="frames">The velocity before and after each frame.</param>
        /// <param name="gain">What the velocity of the frame with this index gains in a second.</param>
        /// <param name="code">What an instructor decides about the gain; null: it is the sheet's.</param>
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

        /// <summary>What the frames say if nothing pushes: no reading, time step or order makes a difference there.</summary>
        public Match[] Unpushed { get; }
    }

    /// <summary>One velocity through all frames, before anything is said of its gain.</summary>
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

        /// <summary>The velocity keeps its direction, whatever pushes: no reading of its gain is better than another.</summary>
        public bool GainsNothing { get; }
    }

    /// <summary>Every way in which the gain of one velocity may rightly be read, the likeliest first.</summary>
    internal sealed class GainReadings
    {
        private readonly Func<IEnumerable<int>> _different;
        private readonly bool _isOneEnough;

        /// <param name="all">The readings, by their numbers.</param>
        /// <param name="different">The numbers of those that are not the same as an earlier one in every frame.</param>
        /// <param name="isOneEnough">No reading is better than another.</param>
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
