using NUnit.Framework;

namespace RigidBodyDynamics.Tests;

/// <summary>
/// The coefficients of the schemes, held against the conditions of order: exponentials of letters that do not commute (p and r
/// push, f is free motion) are multiplied out, and the words of the product are compared with those of e^(p + r + f).
/// </summary>
public sealed class SchemeTests
{
    private const double Rounding = 1e-14;

    // measured 1.1e-16 and 3.3e-16; among words that are one longer 7.5e-4 and 5.2e-5, so there is something to see
    [TestCase(4)]
    [TestCase(6)]
    public void Mirrored_parts_have_their_order_for_any_two_pushes_and_a_motion(int order)
    {
        double[] parts = order == 4 ? default(Order4).Mirrored : default(Order6).Mirrored;
        List<(char, double)> flows = [];
        for (int i = 0; i < parts.Length; i += 2)
        {
            flows.AddRange([('p', parts[i]), ('r', parts[i]), ('f', parts[i])]);
            flows.AddRange([('f', parts[i + 1]), ('r', parts[i + 1]), ('p', parts[i + 1])]);
        }

        Dictionary<string, double> wrong = Wrong(flows, "prf", order + 1);
        Assert.That(Largest(wrong, word => word.Length <= order), Is.LessThan(Rounding));
        Assert.That(Largest(wrong, word => word.Length > order), Is.GreaterThan(1e-6));
    }

    // measured 1.9e-16
    [Test]
    public void Kicks_of_Exact4_have_order_four_for_any_push_and_motion()
    {
        Dictionary<string, double> wrong = Wrong(Flows<Order4>(), "pf", 4);
        Assert.That(Largest(wrong, _ => true), Is.LessThan(Rounding));
    }

    // Nyström's condition: where a push reads the pose alone, [p, [p, [p, f]]] = 0, and what that and its commutators with p and f
    // make wrong is not wrong. Of order 6 nothing can be left, since the scheme is its own mirror image. Measured 1.1e-16
    [Test]
    public void Kicks_of_Exact6_have_order_six_for_a_push_that_reads_the_pose_alone()
    {
        List<(char, double)> flows = Flows<Order6>();
        Assert.That(flows, Is.EqualTo(Enumerable.Reverse(flows)));

        Dictionary<string, double> wrong = Wrong(flows, "pf", 5), f = new() { ["f"] = 1 }, p = new() { ["p"] = 1 };
        Dictionary<string, double> nothing = Commutator(p, Commutator(p, Commutator(p, f)));
        Dictionary<string, double> first = Commutator(f, nothing), second = Commutator(p, nothing);
        double a = wrong["fpppf"] / first["fpppf"], b = wrong["ppppf"] / second["ppppf"];
        Assert.That(Math.Abs(a) + Math.Abs(b), Is.GreaterThan(1e-6), "it needs the condition");
        foreach (string word in wrong.Keys.ToList())
            wrong[word] -= a * first.GetValueOrDefault(word) + b * second.GetValueOrDefault(word);

        Assert.That(Largest(wrong, _ => true), Is.LessThan(Rounding));
    }

    private static List<(char, double)> Flows<TScheme>() where TScheme : struct, IScheme
    {
        double[] kicks = default(TScheme).Kicks, drifts = default(TScheme).Drifts;
        return [.. drifts.SelectMany((drift, i) => new[] { ('p', kicks[i]), ('f', drift) }), ('p', kicks[^1])];
    }

    /// <summary>The difference of each word of the product, up to a length, from the one that it should be, 1/n!.</summary>
    private static Dictionary<string, double> Wrong(List<(char Letter, double Part)> flows, string letters, int longest)
    {
        Dictionary<string, double> product = new() { [string.Empty] = 1 };
        foreach ((char letter, double part) in flows)
        {
            Dictionary<string, double> next = [];
            foreach ((string word, double value) in product)
            {
                double term = value;
                for (int n = 0; n <= longest - word.Length; term *= part / ++n)
                    Add(next, word + new string(letter, n), term);
            }

            product = next;
        }

        double expected = 1;
        IEnumerable<string> words = [string.Empty];
        for (int n = 0; n <= longest; expected /= ++n, words = words.SelectMany(word => letters.Select(letter => word + letter)))
        {
            foreach (string word in words)
                Add(product, word, -expected);
        }

        return product;
    }

    private static Dictionary<string, double> Commutator(Dictionary<string, double> a, Dictionary<string, double> b)
    {
        Dictionary<string, double> result = [];
        foreach ((string x, double s) in a)
        {
            foreach ((string y, double t) in b)
            {
                Add(result, x + y, s * t);
                Add(result, y + x, -s * t);
            }
        }

        return result;
    }

    private static void Add(Dictionary<string, double> sum, string word, double value) => sum[word] = sum.GetValueOrDefault(word) + value;

    private static double Largest(Dictionary<string, double> wrong, Func<string, bool> where)
    {
        double largest = wrong.Where(word => where(word.Key)).Max(word => Math.Abs(word.Value));
        TestContext.Out.WriteLine(largest);
        return largest;
    }
}
