using System.Collections.Generic;
using System.Linq;

namespace RigidBodyDynamics.Judging
{
    /// <summary>The role of a variable in the sheet's formulas.</summary>
    internal enum Role
    {
        Force,
        Torque,
        Velocity,
        AngularVelocity,
        Position,
        Orientation,
        Mass,
        Inertia,
    }

    /// <summary>The names of variables in scripts, the more likely first.</summary>
    internal static class RoleNames
    {
        private static readonly Dictionary<Role, string> Names = new Dictionary<Role, string>
        {
            [Role.Force] = "force f externalforce extforce totalforce netforce forces fext 力 外力 合力 li",
            [Role.Torque] = "torque tau τ t moment externaltorque totaltorque nettorque torques niuju liju 扭矩 力矩",
            [Role.Velocity] = "v velocity vel linearvelocity linvel linearv speed vlinear velo sudu 速度 线速度",
            [Role.AngularVelocity] = "w omega ω angularvelocity angvel angularv angularvel angularspeed wspeed rotvel av jiaosudu 角速度",
            [Role.Position] = "x position pos p currentposition weizhi 位置",
            [Role.Orientation] = "q orientation rotation rot quaternion quat attitude r fangxiang 方向 朝向 四元数",
            [Role.Mass] = "mass m zhiliang 质量 totalmass bodymass",
            [Role.Inertia] = "iref inertiaref inertia i0 ibody irest inertiatensor i j refinertia referenceinertia inertiareference zhuandongguanliang 转动惯量",
        };

        public static Shape ShapeOf(Role role) =>
            role == Role.Mass ? Shape.Number : role == Role.Inertia ? Shape.Matrix : role == Role.Orientation ? Shape.Quaternion : Shape.Vector;

        /// <summary>How well the name suits the role: 0 is best, −1 is not at all.</summary>
        public static int Rank(Role role, string name)
        {
            string last = name.Substring(name.LastIndexOf('.') + 1);
            string plain = last.StartsWith("m_", System.StringComparison.Ordinal) ? last.Substring(2) : last;
            return System.Array.IndexOf(Names[role].Split(' '), plain.Replace("_", "").ToLowerInvariant());
        }

        /// <summary>Variables of the role's shape with one of its names, the most likely first.</summary>
        public static IReadOnlyList<Variable> Candidates(Role role, IEnumerable<Variable> variables) =>
            variables.Where(v => v.Shape == ShapeOf(role) && Rank(role, v.Name) >= 0).OrderBy(v => Rank(role, v.Name)).ToArray();

        /// <summary>True for the name of another quantity: such a variable is not taken for this role because of its behaviour.</summary>
        public static bool IsAnother(Role role, string name) =>
            Names.Keys.Any(r => r != role && ShapeOf(r) == ShapeOf(role) && Rank(r, name) >= 0) || MomentumNames.Contains(name.ToLowerInvariant());

        private static readonly string[] MomentumNames = { "l", "angularmomentum", "momentum", "linearmomentum" };
    }
}
