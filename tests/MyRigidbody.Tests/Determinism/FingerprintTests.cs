using System.Text;
using NUnit.Framework;
using RigidBodyDynamics.BitHash;

namespace RigidBodyDynamics.Tests;

public sealed class FingerprintTests
{
    // Of .NET and of Mono, in Debug and in Release. It changes with a bit of any step or a row of the catalogue; where
    // that is intended, this is the line to change, and MonoTests is to pass with it.
    internal const ulong Golden = 0x1c1d6b91ad233811;

    [Test]
    public void All_integrators_with_all_effects_and_hard_cases_come_to_the_same_bits_everywhere()
    {
        // two runs side by side, which must not disturb one another
        ulong[] hashes = new ulong[2];
        Parallel.For(0, hashes.Length, i => hashes[i] = BitHashScene.Compute());
        Assert.That(hashes.Select(hash => $"0x{hash:x16}"), Is.All.EqualTo($"0x{Golden:x16}"));
    }

    [Test]
    public void Fingerprint_covers_every_effect_of_the_library()
    {
        IEnumerable<Type> covered = BitHashScene.Everything("all", "Exact", inDouble: true).Effects.Select(effect => effect.Motion.GetType());
        IEnumerable<Type> effects = typeof(IEffect).Assembly.GetExportedTypes().Where(type => type.IsValueType && typeof(IEffect).IsAssignableFrom(type))
            .Except([typeof(HeldKeys)]); // keys that are held move a body to the bits of KeyPush, which PlayedBitsTests compare
        Assert.That(covered.Distinct(), Is.EquivalentTo(effects));
    }

    [Test]
    public void Fingerprint_is_FNV_1a_over_the_bytes_of_the_numbers()
    {
        // first the hash function, against a published value
        Assert.That(Fnv(Encoding.ASCII.GetBytes("foobar")), Is.EqualTo(0x85944171f73967e8));

        StateHash hash = default;
        Assert.That(hash.Value, Is.EqualTo(Fnv([])));
        hash.Add(Pushes.State);
        BodyState s = Pushes.State;
        double[] numbers =
        [
            s.Position.X, s.Position.Y, s.Position.Z, s.Orientation.W, s.Orientation.X, s.Orientation.Y, s.Orientation.Z,
            s.Velocity.X, s.Velocity.Y, s.Velocity.Z, s.AngularVelocity.X, s.AngularVelocity.Y, s.AngularVelocity.Z,
        ];
        Assert.That(hash.Value, Is.EqualTo(Fnv([.. numbers.SelectMany(BitConverter.GetBytes)])));
    }

    [Test]
    public void Fingerprint_notices_the_last_bit_and_the_sign_of_a_zero()
    {
        StateHash one = default, next = default, zero = default, minus = default;
        one.Add(1);
        next.Add(Math.BitIncrement(1));
        zero.Add(0);
        minus.Add(-0.0);
        Assert.That(new[] { one.Value, next.Value, zero.Value, minus.Value }, Is.Unique);
    }

    private static ulong Fnv(byte[] bytes)
    {
        ulong hash = 0xcbf29ce484222325;
        foreach (byte b in bytes)
            hash = (hash ^ b) * 0x100000001b3;
        return hash;
    }
}
