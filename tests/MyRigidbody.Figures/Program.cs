using System.CommandLine;
using RigidBodyDynamics.Figures;

Argument<string> folder = new("folder") { Description = "Where cost.csv, bench.csv and engines.csv are." };
Argument<string[]> pages = new("page") { Description = "Pages with tables between \"figures: NAME\" and \"end\".", Arity = ArgumentArity.OneOrMore };
Command check = new("check", "Lists where pages and measurement part by more than noise; exit code 1 if they do anywhere.") { folder, pages };
Command write = new("write", "Puts what was measured into the pages.") { folder, pages };
check.SetAction(parsed =>
{
    Measured measured = new(parsed.GetValue(folder)!);
    int tables = 0, differences = 0;
    foreach (string page in parsed.GetValue(pages)!)
    {
        string text = File.ReadAllText(page);
        tables += Page.Count(text);
        foreach (string difference in Page.Differences(text, name => Tables.Of(name, measured, IsChinese(page))))
        {
            Console.WriteLine($"{page}: {difference}");
            differences++;
        }
    }

    Console.WriteLine($"{tables} tables, {differences} figures that part from what was measured");
    return tables > 0 && differences == 0 ? 0 : 1;
});
write.SetAction(parsed =>
{
    Measured measured = new(parsed.GetValue(folder)!);
    foreach (string page in parsed.GetValue(pages)!)
        File.WriteAllText(page, Page.Written(File.ReadAllText(page), name => Tables.Of(name, measured, IsChinese(page))));
});
return new RootCommand("Tables of figures on pages, held to what cost and bench measure.") { check, write }.Parse(args).Invoke();

static bool IsChinese(string page) => page.EndsWith(".zh.md", StringComparison.Ordinal);
