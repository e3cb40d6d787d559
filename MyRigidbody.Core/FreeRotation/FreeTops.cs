namespace RigidBodyDynamics
{
    /// <summary>Chooses a body's kind of top, once, from its moments: the cheapest that is exact.</summary>
    internal static class FreeTops
    {
        /// <summary>An operation on the kind of top as a type.</summary>
        public interface IUse<TResult>
        {
            TResult With<TTop>() where TTop : struct, IFreeTop;
        }

        /// <summary>A kind of top in words.</summary>
        public sealed class Words : IUse<string>
        {
            public string With<TTop>() where TTop : struct, IFreeTop =>
                typeof(TTop) == typeof(SphericalTop) ? "a body with three equal moments"
                : typeof(TTop) == typeof(SymmetricTop) ? "a body with two equal moments"
                : "a body with three different moments";
        }

        public static TResult Choose<TResult>(BodyDescription body, IUse<TResult> use)
        {
            if (!body.CanTurn)
                return use.With<HeldTop>();

            Vector3d i = body.Mass.PrincipalMoments;
            if (body.Mass.IsIsotropic)
                return use.With<SphericalTop>();

            return i.X == i.Y || i.Y == i.Z || i.Z == i.X ? use.With<SymmetricTop>() : use.With<AsymmetricTop>();
        }
    }
}
