using System.CommandLine;
using System.Globalization;
using System.Text.Json;
using RigidBodyDynamics.Lab.Output;

namespace RigidBodyDynamics.Lab.Commands;

/// <summary>Prints the catalogue.</summary>
internal static class IntegratorsCommand
{
    private static readonly JsonSerializerOptions Indented = new() { WriteIndented = true };

    public static Command Create()
    {
        Option<bool> json = new("--json") { Description = "as JSON" };
        Command command = new("integrators", "The catalogue: every rule by which a body can move") { json };
        command.SetAction(parsed => Execute(parsed.GetValue(json)));
        return command;
    }

    private static int Execute(bool json)
    {
        if (json)
        {
            var rows = Catalogue.Rows.Select(row => new
            {
                name = row.Name,
                order = row.Order,
                keeps = row.Keeps.ToString().Split(", "),
                cost = row.Cost.ToString(),
                isDefault = row == Catalogue.Default,
                about = row.About,
            });
            Terminal.WriteJson(JsonSerializer.Serialize(rows, Indented));
            return 0;
        }

        TextTable table = new("integrator", "order", "keeps, turning freely", "a step costs", "what it is");
        foreach (CatalogueRow row in Catalogue.Rows)
        {
            string name = row == Catalogue.Default ? row.Name + " (default)" : row.Name;
            table.AddRow(name, row.Order.ToString(CultureInfo.InvariantCulture), Words(row.Keeps), Words(row.Cost), row.About);
        }

        Terminal.Write(table);
        return 0;
    }

    private static string Words(Keeps keeps) =>
        keeps.HasFlag(Keeps.Energy) ? "L, energy"
        : keeps.HasFlag(Keeps.EnergyBounded) ? "L; energy swings"
        : keeps.HasFlag(Keeps.Momentum) ? "L"
        : keeps.HasFlag(Keeps.MomentumLength) ? "|L|"
        : keeps.HasFlag(Keeps.Motion) ? "–"
        : "ω, wrongly";

    private static string Words(Cost cost) => cost switch
    {
        Cost.LikeTheLab => "about the lab's",
        _ => "several of the lab's",
    };
}
