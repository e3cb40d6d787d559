using System.Globalization;
using NUnit.Framework;
using RigidBodyDynamics.Tests.Repository;

namespace RigidBodyDynamics.Tests;

/// <summary>The order that the catalogue declares is the order of every effect, alone and beside every other.</summary>
public sealed class OrderOfEffectsTests
{
    private const string Page = "docs/integrators.md";
    private static readonly IReadOnlyList<OrderedEffect> Effects = OrderedEffect.All;
    private static readonly Dictionary<string, Lazy<double[,]>> Measured =
        Rules.All.ToDictionary(row => row.Name, row => new Lazy<double[,]>(() => Measure(row.Name)));

    private static IEnumerable<string> RuleNames => Rules.All.Select(row => row.Name);

    private static IEnumerable<string> Compositions => ["Exact", "Exact4", "Exact6"];

    // measured: 0.97 to 1.01, 2.00, 3.9 to 4.1, 5.9 to 6.1
    [TestCaseSource(nameof(RuleNames))]
    public void Order_under_any_effect_and_any_two_is_the_declared_one(string integrator)
    {
        double[,] orders = Measured[integrator].Value;
        for (int i = 0; i < Effects.Count; i++)
        {
            for (int j = 0; j <= i; j++)
                Is_declared(integrator, orders[i, j], Effects[i], Effects[j]);
        }
    }

    [Test]
    public void Order_is_measured_of_every_effect_of_the_library()
    {
        static BodyDescription With(OrderedEffect effect)
        {
            BodyDescription body = new("body", Solids.Sphere(1, 1));
            effect.GiveTo(body, OrderedEffect.DecayStep, 0, 1);
            return body;
        }

        IEnumerable<Type> lasting = typeof(IEffect).Assembly.GetExportedTypes()
            .Where(type => type.IsValueType && (typeof(IPush).IsAssignableFrom(type) || typeof(ICoast).IsAssignableFrom(type)))
            .Except([typeof(HeldKeys)]); // keys that are held move a body to the bits of KeyPush
        Assert.That(Effects.Select(effect => With(effect).Effects[0].Motion.GetType()), Is.SupersetOf(lasting));
    }

    // measured as above
    [TestCaseSource(nameof(Compositions))]
    public void Order_under_an_effect_in_a_window_is_the_declared_one(string integrator)
    {
        foreach (OrderedEffect effect in Effects)
            Is_declared(integrator, MeasuredOrder.Of(integrator, true, effect), effect);
    }

    // measured 2.00, 3.99 to 4.02, 5.93 to 6.05
    [TestCaseSource(nameof(Compositions))]
    public void Order_is_the_declared_one_for_a_cube_and_a_wheel_too(string integrator)
    {
        // one that reads the pose, one that reads velocities: two schemes
        OrderedEffect spring = Effect("spring off the centre"), lift = Effect("lift of the spin (v, ω)");
        foreach (Vector3d moments in new[] { MeasuredOrder.Cube, new(1.5, 1.5, 2.5) })
        {
            foreach (OrderedEffect effect in Effects)
            {
                Is_declared(integrator, MeasuredOrder.Of(integrator, moments, false, effect, spring), effect);
                Is_declared(integrator, MeasuredOrder.Of(integrator, moments, false, effect, lift), effect);
            }
        }
    }

    // must fail: the schemes for forces that read the pose alone, forced on what reads a velocity, as it was done once
    [Test]
    public void Schemes_for_pushes_that_read_the_pose_alone_lose_their_order_where_one_reads_a_velocity()
    {
        OrderedEffect drag = Effect("quadratic drag"), spring = Effect("spring off the centre"), wind = Effect("wind in gusts (v, t)");
        QuadraticDrag drags = (QuadraticDrag)drag.Push!(0);
        Assert.That(Old<Old4, QuadraticDrag>(4, drags, drag), Is.EqualTo(4).Within(0.2));
        Assert.That(Old<Old6, QuadraticDrag>(6, drags, drag), Is.EqualTo(4).Within(0.2));
        Assert.That(Old<Old6, Wind>(6, (Wind)wind.Push!(0), wind), Is.EqualTo(4).Within(0.2));

        Both<QuadraticDrag, Spring> both = new(drags, (Spring)spring.Push!(0));
        Assert.That(Old<Old4, Both<QuadraticDrag, Spring>>(4, both, drag, spring), Is.EqualTo(2).Within(0.2));
        Assert.That(Old<Old6, Both<QuadraticDrag, Spring>>(6, both, drag, spring), Is.EqualTo(2).Within(0.2));
        Assert.That(Old<Order4, Both<QuadraticDrag, Spring>>(4, both, drag, spring), Is.EqualTo(4).Within(0.2));
        Assert.That(Old<Order6, Both<QuadraticDrag, Spring>>(6, both, drag, spring), Is.EqualTo(6).Within(0.2));
    }

    [Test]
    public void Order_for_a_body_is_one_where_a_factor_acts_once_a_step()
    {
        Rule row = Rules.Exact6;
        Assert.That(row.OrderFor(Scenery.Body("Exact6").With(new LinearDamping(1)).With(new DecayPerStep(1, 1))), Is.EqualTo(6));
        Assert.That(row.OrderFor(Scenery.Body("Exact6").With(new DecayPerStep(0.98, 1))), Is.EqualTo(1));
        Assert.That(row.OrderFor(Scenery.Body("Exact6").With(new DecayPerStep(1, 0.98), 3, 4)), Is.EqualTo(1));
    }

    [Test]
    public void Table_of_orders_on_the_page_is_measured()
    {
        string[] page = [.. File.ReadLines(Root.File(Page)).SkipWhile(line => line != "<!-- orders -->").Skip(3).TakeWhile(line => line != "<!-- end -->")];
        string[] measured = [.. Effects.Select(Line)];
        TestContext.Out.WriteLine(string.Join('\n', measured));
        Assert.That(page.Select(line => line.Split('|')[1]), Is.EqualTo(measured.Select(line => line.Split('|')[1])));
        foreach ((string shown, string found) in page.Zip(measured))
        {
            double[] a = Numbers(shown), b = Numbers(found);
            Assert.That(a, Has.Length.EqualTo(b.Length), found);
            Assert.That(a.Zip(b, (x, y) => Math.Abs(x - y)), Is.All.LessThan(0.15), found);
        }

        static double[] Numbers(string line) =>
            [.. line.Split('|')[2..].SelectMany(cell => cell.Split(' ', '–', ';')).Where(word => double.TryParse(word, CultureInfo.InvariantCulture, out _)).Select(word => double.Parse(word, CultureInfo.InvariantCulture))];
    }

    private static void Is_declared(string integrator, double order, params OrderedEffect[] effects)
    {
        if (double.IsPositiveInfinity(order))
            return;

        BodyDescription body = MeasuredOrder.Body(integrator, MeasuredOrder.Moments);
        foreach (OrderedEffect effect in effects)
            effect.GiveTo(body, 0.1, 0, 1);

        Assert.That(order, Is.EqualTo(Rules.Named(integrator).OrderFor(body)).Within(0.2), string.Join(" and ", effects.Distinct().Select(effect => effect.Name)));
    }

    /// <summary>A row of the page: alone; and beside every other but the factor per step, from the lowest to the highest.</summary>
    private static string Line(OrderedEffect effect)
    {
        int i = Effects.ToList().IndexOf(effect);
        IEnumerable<string[]> columns = [[.. RuleNames.Where(row => Rules.Named(row).Order == 1)], .. RuleNames.Where(row => Rules.Named(row).Order > 1).Select(row => new[] { row })];
        return "| " + effect.Name + " | " + string.Join(" | ", columns.Select(rows =>
            Range(rows.Select(row => Measured[row].Value[i, i])) + "; "
            + Range(rows.SelectMany(row => Enumerable.Range(0, Effects.Count).Where(j => j != i && !Effects[j].IsPerStep).Select(j => Measured[row].Value[i, j]))))) + " |";

        static string Range(IEnumerable<double> orders)
        {
            double[] seen = [.. orders.Where(order => !double.IsPositiveInfinity(order))];
            string low = seen.Length == 0 ? "exact" : seen.Min().ToString("f1", CultureInfo.InvariantCulture), high = seen.Length == 0 ? low : seen.Max().ToString("f1", CultureInfo.InvariantCulture);
            return low == high ? low : low + "–" + high;
        }
    }

    private static double[,] Measure(string integrator)
    {
        double[,] orders = new double[Effects.Count, Effects.Count];
        for (int i = 0; i < Effects.Count; i++)
        {
            for (int j = 0; j <= i; j++)
                orders[i, j] = orders[j, i] = i == j ? MeasuredOrder.Of(integrator, false, Effects[i]) : MeasuredOrder.Of(integrator, false, Effects[i], Effects[j]);
        }

        return orders;
    }

    private static OrderedEffect Effect(string name) => Effects.Single(effect => effect.Name == name);

    private static double Old<TScheme, TPush>(int declared, TPush push, params OrderedEffect[] effects)
        where TScheme : struct, IScheme
        where TPush : struct, IPush
    {
        double order = MeasuredOrder.Of(
            declared,
            steps =>
            {
                Composition<AsymmetricTop, TScheme> rule = default;
                rule.Start(new Beginning(MeasuredOrder.Body("Exact", MeasuredOrder.Moments)));
                rule.Prepare(MeasuredOrder.Time / steps, Coasting.Free);
                for (int i = 0; i < steps; i++)
                    rule.Step(new Instant(i, i * MeasuredOrder.Time / steps), ref push);

                return rule.State;
            },
            MeasuredOrder.Truth(MeasuredOrder.Moments, false, effects));
        TestContext.Out.WriteLine($"{typeof(TScheme).Name}: {order:f2}");
        return order;
    }

    private struct Old4 : IScheme
    {
        public readonly double[] Kicks => default(Order4).Kicks;

        public readonly double[] Drifts => default(Order4).Drifts;

        public readonly bool HoldsTime => true;

        public readonly double[]? Mirrored => null;
    }

    private struct Old6 : IScheme
    {
        public readonly double[] Kicks => default(Order6).Kicks;

        public readonly double[] Drifts => default(Order6).Drifts;

        public readonly bool HoldsTime => true;

        public readonly double[]? Mirrored => null;
    }
}
