namespace RigidBodyDynamics.Judging
{
    /// <summary>One difference from the sheet, measured, with one sentence of help in each language.</summary>
    public sealed class Finding
    {
        public Finding(Step step, string code, string expected, string found, string english, string chinese)
        {
            Step = step;
            Code = code;
            Expected = expected;
            Found = found;
            English = english;
            Chinese = chinese;
        }

        public Step Step { get; }

        /// <summary>A short word for the kind, such as <c>half-missing</c>.</summary>
        public string Code { get; }

        /// <summary>True if an instructor decides whether it counts.</summary>
        public bool IsDoubtful { get; private set; }

        /// <summary>The line of the script, from 1; null where it is unknown.</summary>
        public int? Line { get; private set; }

        /// <summary>The first frame in which it shows, from 0 in its experiment; null where it does not belong to a frame.</summary>
        public int? Since { get; private set; }

        /// <summary>The experiment of <see cref="Since"/>.</summary>
        public string Experiment { get; private set; }

        public string Expected { get; }

        public string Found { get; }

        public string English { get; }

        public string Chinese { get; }

        public Finding At(int line) => new Finding(this) { Line = line };

        public Finding From(string experiment, int frame) => new Finding(this) { Experiment = experiment, Since = frame };

        public Finding ForInstructor() => new Finding(this) { IsDoubtful = true };

        private Finding(Finding other) : this(other.Step, other.Code, other.Expected, other.Found, other.English, other.Chinese)
        {
            IsDoubtful = other.IsDoubtful;
            Line = other.Line;
            Since = other.Since;
            Experiment = other.Experiment;
        }
    }
}
