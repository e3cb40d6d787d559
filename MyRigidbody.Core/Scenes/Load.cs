using System;

namespace RigidBodyDynamics
{
    /// <summary>The load: force and torque that a program applies to one body during one step.</summary>
    internal struct Load
    {
        /// <summary>The step in which it acts.</summary>
        public long Step;

        /// <summary>Force and torque at the centre of mass, N and N m; the torque's part in body axes rotates with the body.</summary>
        public Wrench Wrench;

        /// <summary>Force in body axes at the centre of mass, N: it rotates with the body.</summary>
        public Vector3d BodyForce;

        /// <summary>No load, in a step that never comes.</summary>
        public static Load None => new Load { Step = -1 };

        /// <summary>Force and torque of a force at a point, or their impulses (N s, N m s).</summary>
        /// <param name="push">The force or impulse, in world or body axes.</param>
        /// <param name="arm">From the centre of mass to the point, m, in the same axes.</param>
        /// <param name="inBody">True for body axes, false for those of the world.</param>
        public static Load Of(Vector3d push, Vector3d arm, bool inBody)
        {
            Vector3d torque = Vector3d.Cross(arm, push);
            return inBody
                ? new Load { BodyForce = push, Wrench = new Wrench { BodyTorque = torque } }
                : new Load { Wrench = new Wrench { Force = push, Torque = torque } };
        }

        /// <summary>The sum of two loads on a body of this name.</summary>
        public Load With(in Load more, string body)
        {
            Load sum = this;
            sum.Wrench.Force += more.Wrench.Force;
            sum.Wrench.Torque += more.Wrench.Torque;
            sum.Wrench.BodyTorque += more.Wrench.BodyTorque;
            sum.BodyForce += more.BodyForce;
            return sum.Wrench.IsFinite && sum.BodyForce.IsFinite
                ? sum
                : throw new OverflowException("body \"" + body + "\": the sum of what is applied in this step must be finite");
        }

        /// <summary>The parts of the motion that it needs.</summary>
        public Omissions Needs =>
            (Wrench.Force.IsZero && BodyForce.IsZero ? Omissions.None : Omissions.Translation)
            | (Wrench.Torque.IsZero && Wrench.BodyTorque.IsZero ? Omissions.None : Omissions.Rotation);

        /// <summary>The same with the force in world axes.</summary>
        public Wrench At(Quaterniond orientation)
        {
            Wrench at = Wrench;
            at.Force += orientation.Rotate(BodyForce);
            return at;
        }
    }

    /// <summary>A load as a push: the last of a sum, in the steps that have a load.</summary>
    internal readonly struct Loaded : IPush
    {
        private readonly Mover _mover;

        public Loaded(Mover mover) => _mover = mover;

        public EffectTraits Traits =>
            EffectTraits.Moves | EffectTraits.Turns | (_mover.Load.BodyForce.IsZero ? EffectTraits.None : EffectTraits.ReadsOrientation);

        public void At(in Instant now, in BodyState body, MassProperties mass, ref Wrench wrench) => Over(now, 1, body, mass, ref wrench);

        public void Over(in Instant now, double duration, in BodyState body, MassProperties mass, ref Wrench impulse)
        {
            Wrench load = _mover.Load.BodyForce.IsZero ? _mover.Load.Wrench : _mover.Load.At(body.Orientation);
            impulse.Force += duration * load.Force;
            impulse.Torque += duration * load.Torque;
            impulse.BodyTorque += duration * load.BodyTorque;
        }
    }
}
