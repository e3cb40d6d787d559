using System.Collections;
using System.Collections.Generic;
using System.Linq;

namespace RigidBodyDynamics.Judging
{
    /// <summary>When the factor of step 5 is applied.</summary>
    internal enum Order
    {
        /// <summary>At the end of the frame, as on the sheet.</summary>
        GainThenDecay,

        /// <summary>At the beginning, which is the end of the frame before.</summary>
        DecayThenGain,

        /// <summary>At the beginning and at the end.</summary>
        DecayGainDecay,
    }

    /// <summary>One reading of the gain with the three orders of gain and decay, the sheet's first; each is computed when it is read.</summary>
    internal sealed class Orders : IEnumerable<Chain>
    {
        private static readonly Order[] All = { Order.GainThenDecay, Order.DecayThenGain, Order.DecayGainDecay };

        private readonly Links _links;
        private readonly TimeStep _step;
        private readonly Chain[] _chains = new Chain[All.Length];

        public Orders(Links links, TimeStep step)
        {
            _links = links;
            _step = step;
        }

        public bool GainIsRight => this.Any(chain => chain.GainIsRight);

        /// <summary>The cost of the cheapest order; no cost is below zero.</summary>
        public int Cost
        {
            get
            {
                int least = int.MaxValue;
                foreach (Chain chain in this)
                {
                    least = System.Math.Min(least, chain.Cost);
                    if (least == 0)
                        break;
                }

                return least;
            }
        }

        public IEnumerator<Chain> GetEnumerator()
        {
            for (int i = 0; i < All.Length; i++)
                yield return _chains[i] ?? (_chains[i] = new Chain(_links, _step, All[i]));
        }

        IEnumerator IEnumerable.GetEnumerator() => GetEnumerator();
    }
}
