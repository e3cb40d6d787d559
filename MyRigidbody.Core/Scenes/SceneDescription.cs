using System.Collections.Generic;

namespace RigidBodyDynamics
{
    /// <summary>Bodies and the time in which they move.</summary>
    public sealed class SceneDescription
    {
        /// <summary>A scene.</summary>
        public SceneDescription(string name, string about, TimeSteps steps, IReadOnlyList<BodyDescription> bodies)
        {
            Name = Guard.NotNull(name, nameof(name));
            About = Guard.NotNull(about, nameof(about));
            Steps = Guard.NotNull(steps, nameof(steps));
            Bodies = Guard.NotNull(bodies, nameof(bodies));
            HashSet<string> names = new HashSet<string>();
            for (int i = 0; i < bodies.Count; i++)
            {
                if (!names.Add(Guard.NotNull(bodies[i], "bodies[" + i + "]").Name))
                    throw Guard.Refused("bodies[" + i + "].name", bodies[i].Name, "must be unique in the scene");
            }
        }

        /// <summary>Short name.</summary>
        public string Name { get; }

        /// <summary>One line about it.</summary>
        public string About { get; }

        /// <summary>How its time is divided.</summary>
        public TimeSteps Steps { get; }

        /// <summary>Its bodies.</summary>
        public IReadOnlyList<BodyDescription> Bodies { get; }
    }
}
