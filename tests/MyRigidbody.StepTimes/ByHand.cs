using System;

namespace RigidBodyDynamics.StepTimes
{
    /// <summary>
    /// The lab's five formulas written for one body, component by component in one method: the cost of a step without any generality. It must give
    /// the bits of the library's, or no time is printed.
    /// </summary>
    internal sealed class ByHand
    {
        private const double Dt = 0.02;
        private readonly double _ix, _iy, _iz, _m, _decay, _fx, _fy, _fz, _g;
        private readonly bool _isTurned;
        private double _x, _y, _z, _vx, _vy, _vz, _qw, _qx, _qy, _qz, _wx, _wy, _wz;
        private long _step;

        /// <summary>A body with moments along its axes, under a force, gravity along y, a factor per step and, if it is turned, the key R.</summary>
        public ByHand(BodyDescription body, Vector3d force, double gravity, double decay, bool isTurned)
        {
            Vector3d i = body.Mass.PrincipalMoments, x = body.Start.Position, v = body.Start.Velocity, w = body.Start.AngularVelocity;
            Quaterniond q = body.Start.Orientation;
            (_ix, _iy, _iz, _m) = (i.X, i.Y, i.Z, body.Mass.Mass);
            (_fx, _fy, _fz, _g) = (force.X, force.Y, force.Z, gravity);
            (_decay, _isTurned) = (decay, isTurned);
            (_x, _y, _z, _vx, _vy, _vz) = (x.X, x.Y, x.Z, v.X, v.Y, v.Z);
            (_qw, _qx, _qy, _qz, _wx, _wy, _wz) = (q.W, q.X, q.Y, q.Z, w.X, w.Y, w.Z);
        }

        public BodyState State => new BodyState(
            new Vector3d(_x, _y, _z), new Quaterniond(_qw, _qx, _qy, _qz), new Vector3d(_vx, _vy, _vz), new Vector3d(_wx, _wy, _wz));

        public void Step(long count)
        {
            double x = _x, y = _y, z = _z, vx = _vx, vy = _vy, vz = _vz, qw = _qw, qx = _qx, qy = _qy, qz = _qz, wx = _wx, wy = _wy, wz = _wz;
            for (long end = _step + count; _step < end; _step++)
            {
                // 1. v = v + Δt (F / m + g)
                vx += Dt * (_fx / _m);
                vy += Dt * (_fy / _m + _g);
                vz += Dt * (_fz / _m);

                // 2. ω = ω + Δt I⁻¹ τ with I = R I_ref Rᵀ
                if (_isTurned)
                {
                    Elementary.SinCos(_step * Dt, out double t, out double _);
                    double r11 = 1 - 2 * (qy * qy + qz * qz), r12 = 2 * (qx * qy - qw * qz), r13 = 2 * (qx * qz + qw * qy);
                    double r21 = 2 * (qx * qy + qw * qz), r22 = 1 - 2 * (qx * qx + qz * qz), r23 = 2 * (qy * qz - qw * qx);
                    double r31 = 2 * (qx * qz - qw * qy), r32 = 2 * (qy * qz + qw * qx), r33 = 1 - 2 * (qx * qx + qy * qy);
                    double i11 = r11 * (_ix * r11) + r12 * (_iy * r12) + r13 * (_iz * r13), i12 = r11 * (_ix * r21) + r12 * (_iy * r22) + r13 * (_iz * r23);
                    double i22 = r21 * (_ix * r21) + r22 * (_iy * r22) + r23 * (_iz * r23), i23 = r21 * (_ix * r31) + r22 * (_iy * r32) + r23 * (_iz * r33);
                    double i33 = r31 * (_ix * r31) + r32 * (_iy * r32) + r33 * (_iz * r33), i13 = r11 * (_ix * r31) + r12 * (_iy * r32) + r13 * (_iz * r33);
                    double c11 = i22 * i33 - i23 * i23, c12 = i13 * i23 - i12 * i33, c13 = i12 * i23 - i13 * i22;
                    double c22 = i11 * i33 - i13 * i13, c23 = i12 * i13 - i11 * i23, c33 = i11 * i22 - i12 * i12;
                    double s = 1 / (i11 * c11 + i12 * c12 + i13 * c13);
                    wx += Dt * (s * c11 * t + s * c12 * t + s * c13 * t);
                    wy += Dt * (s * c12 * t + s * c22 * t + s * c23 * t);
                    wz += Dt * (s * c13 * t + s * c23 * t + s * c33 * t);
                }

                // 3. x = x + Δt v
                x += Dt * vx;
                y += Dt * vy;
                z += Dt * vz;

                // 4. q = q + [0, ½ Δt ω] q, then back to length 1
                double hx = 0.5 * Dt * wx, hy = 0.5 * Dt * wy, hz = 0.5 * Dt * wz;
                double nw = qw - (hx * qx + hy * qy + hz * qz), nx = qx + (hx * qw + hy * qz - hz * qy);
                double ny = qy + (hy * qw + hz * qx - hx * qz), nz = qz + (hz * qw + hx * qy - hy * qx);
                double n = 1 / Math.Sqrt(nw * nw + nx * nx + ny * ny + nz * nz);
                qw = n * nw;
                qx = n * nx;
                qy = n * ny;
                qz = n * nz;

                // 5. v = 0.98 v and ω = 0.98 ω
                if (_decay != 1)
                {
                    vx *= _decay;
                    vy *= _decay;
                    vz *= _decay;
                    wx *= _decay;
                    wy *= _decay;
                    wz *= _decay;
                }
            }

            (_x, _y, _z, _vx, _vy, _vz) = (x, y, z, vx, vy, vz);
            (_qw, _qx, _qy, _qz, _wx, _wy, _wz) = (qw, qx, qy, qz, wx, wy, wz);
        }
    }
}
