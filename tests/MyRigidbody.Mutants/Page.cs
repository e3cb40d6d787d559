namespace RigidBodyDynamics.Mutants;

/// <summary>The page about all mutants.</summary>
internal static class Page
{
    public static string Of(int places, int asked, string figures, string survivors) =>
        $"""
        # Mutants

        What the tests notice: the Core's `Mathematics`, `Bodies`, `FreeRotation` and `Integrators` are changed in one place at
        a time (a sign, a term, a factor, a comparison, a condition, a component, a number, a statement), and the tests that
        reach the place run until one fails. Written by `dotnet run -c Release --project tests/MyRigidbody.Mutants`; the reasons
        are in `reasons.json` beside it.

        Of {places} places {(asked == places ? "all" : asked + ", drawn at random,")} have been asked about so far.

        {figures}
        The golden hash is one number over the bits of every integrator and effect. It notices nearly every change and tells
        nothing about right and wrong, so it is counted apart. Mutants that do not compile, or compile to the same code, are
        not counted. Where a survivor does the same as the original but for time and last bits, the reason says so and it is
        counted apart. Tests that start processes, read the repository or are about other folders were not asked.

        ## Survivors
        {survivors}
        """;
}
