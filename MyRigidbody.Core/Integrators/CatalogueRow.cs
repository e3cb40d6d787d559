namespace RigidBodyDynamics
{
    /// <summary>What a step costs, in steps of the lab.</summary>
    public enum Cost
    {
        /// <summary>Up to one and a half times the lab's step.</summary>
        LikeTheLab,

        /// <summary>More than that.</summary>
        SeveralTimesTheLab,
    }

    /// <summary>An integrator in the catalogue, and what it promises.</summary>
    public abstract class CatalogueRow
    {
        internal CatalogueRow(string name, int order, Cost cost, string about)
        {
            Name = name;
            Order = order;
            Cost = cost;
            About = about;
        }

        /// <summary>The name by which scenes and commands call it.</summary>
        public string Name { get; }

        /// <summary>The error after a given time falls with this power of the step, where the rule converges at all.</summary>
        public int Order { get; }

        /// <summary>What a step costs.</summary>
        public Cost Cost { get; }

        /// <summary>One line about it.</summary>
        public string About { get; }

        internal abstract Body Build(BodyDescription description, TimeSteps steps);
    }

    /// <summary>A row whose rule is the struct <typeparamref name="TIntegrator"/>.</summary>
    internal sealed class CatalogueRow<TIntegrator> : CatalogueRow where TIntegrator : struct, IIntegrator
    {
        public CatalogueRow(string name, int order, Cost cost, string about) : base(name, order, cost, about) { }

        internal override Body Build(BodyDescription description, TimeSteps steps) => new Body<TIntegrator>(description, steps);
    }

    /// <summary>The row whose rule is chosen by the body's own precision.</summary>
    internal sealed class UnityRow : CatalogueRow
    {
        public UnityRow(string name, int order, Cost cost, string about) : base(name, order, cost, about) { }

        internal override Body Build(BodyDescription description, TimeSteps steps)
        {
            if (description.Unity.InDouble)
                return new Body<UnityRigidbody<ToDouble>>(description, steps);

            return new Body<UnityRigidbody<ToSingle>>(description, steps);
        }
    }
}
