using System.CommandLine;
using System.Text.Json;
using RigidBodyDynamics.Lab.Output;
using Spectre.Console;

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
                cost = row.Cost.ToString(),
                isDefault = row == Catalogue.Default,
                about = row.About,
            });
            Console.Out.WriteLine(JsonSerializer.Serialize(rows, Indented));
            return 0;
        }

        Table table = Terminal.NewTable("integrator", "order", "a step costs", "what it is");
        foreach (CatalogueRow row in Catalogue.Rows)
        {
            string name = row == Catalogue.Default ? row.Name + " (default)" : row.Name;
            table.AddRow(new Text(name), new Text(row.Order.ToString()), new Text(Words(row.Cost)), new Text(row.About));
        }

        Terminal.Out.Write(table);
        return 0;
    }

    private static string Words(Cost cost) => cost switch
    {
        Cost.LikeTheLab => "about the lab's",
        _ => "several of the lab's",
    };
}
