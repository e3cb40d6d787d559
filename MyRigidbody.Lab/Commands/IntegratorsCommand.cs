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
        Command command = new("integrators", "The catalogue: every integrator by which a body can move") { json };
        command.SetAction(parsed => Execute(parsed.GetValue(json)));
        return command;
    }

    private static int Execute(bool json)
    {
        if (json)
        {
            var rows = Rules.All.Select(rule => new
            {
                name = rule.Name,
                order = rule.Order,
                keeps = rule.Keeps.ToString().Split(", "),
                cost = rule.Cost.ToString(),
                isDefault = rule == Rules.Default,
                about = rule.About,
            });
            Terminal.WriteJson(JsonSerializer.Serialize(rows, Indented));
            return 0;
        }

        TextTable table = new("integrator", "order", "keeps, turning freely", "a step costs", "what it is");
        foreach (Rule rule in Rules.All)
        {
            string name = rule == Rules.Default ? rule.Name + " (default)" : rule.Name;
            table.AddRow(name, rule.Order.ToString(CultureInfo.InvariantCulture), Words(rule.Keeps), Words(rule.Cost), rule.About);
        }

        Terminal.Write(table);
        return 0;
    }

    private static string Words(Keeps keeps) =>
        keeps.HasFlag(Keeps.Energy) ? "L, energy"
        : keeps.HasFlag(Keeps.EnergyBounded) ? "L; energy oscillates"
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
