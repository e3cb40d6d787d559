using RigidBodyDynamics.Lab.Languages;
using Spectre.Console;
using Spectre.Console.Rendering;

namespace RigidBodyDynamics.Lab.Output;

/// <summary>A table for a terminal; its cells are texts of one line.</summary>
internal sealed class TextTable
{
    private readonly Table _table = new Table().Border(TableBorder.Rounded);

    /// <summary>A table with these headings.</summary>
    public TextTable(params IEnumerable<string> headings)
    {
        foreach (string heading in headings)
            _table.AddColumn(new TableColumn(new Text(Visible.Line(Language.Say(heading)), new Style(decoration: Decoration.Bold))));
    }

    public int Columns => _table.Columns.Count;

    /// <summary>Aligns numbers to the right: in these columns, or in all but the first.</summary>
    public TextTable RightAligned(params int[] columns)
    {
        foreach (int column in columns.Length > 0 ? columns : Enumerable.Range(1, Columns - 1))
            _table.Columns[column].RightAligned();

        return this;
    }

    /// <summary>A row, with a text for every column.</summary>
    public void AddRow(params IEnumerable<string> cells) => _table.AddRow(cells.Select(cell => new Text(Visible.Line(Language.Say(cell)))));

    internal IRenderable Drawn => _table;
}
