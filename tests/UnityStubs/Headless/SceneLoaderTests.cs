using System.IO;
using System.Linq;
using System.Text.RegularExpressions;
using NUnit.Framework;
using RigidBodyDynamics.Engine;
using UnityEngine;
using UnityEngine.SceneManagement;
using UnityEngine.TestTools;

namespace RigidBodyDynamics.Scripts.Tests.Headless
{
    /// <summary>A small scene of our own becomes what it says.</summary>
    public sealed class SceneLoaderTests
    {
        private GameObject[] _roots;

        [Test]
        public void Objects_come_in_the_order_of_the_hierarchy_with_their_parents()
        {
            Load(Written());

            Assert.That(_roots.Select(root => root.name), Is.EqualTo(new[] { "First", "Second" }));
            Transform child = _roots[1].transform.GetChild(0);
            Assert.That(child.position.Equals(new Vector3(3, 2, 3)), Is.True);
            Assert.That(child.lossyScale.Equals(new Vector3(2, 2, 2)), Is.True);
            Assert.That(child.gameObject.activeInHierarchy, Is.False);
            Assert.That(child.GetComponent<Camera>().enabled, Is.False);
        }

        [Test]
        public void Scripts_get_their_fields_before_they_wake()
        {
            Load(Written());

            MyRigidbody mine = _roots[1].GetComponent<MyRigidbody>();
            Assert.That(mine.mass, Is.EqualTo(1.25));
            Assert.That(mine.inertia, Is.EqualTo(InertiaKind.MeshVertices));
            Assert.That(mine.damping, Is.EqualTo(DampingKind.None));
            Assert.That(mine.readsKeys, Is.False);
            Assert.That(mine.linearDecay, Is.EqualTo(0.98), "what the file does not name keeps its value");
            Assert.That(mine.comparedWith, Is.SameAs(_roots[0].GetComponent<DefaultRigidbody>()));
            Assert.That(mine.Body.Rule.Name, Is.EqualTo("Exact"));
            Assert.That(mine.State.Velocity.X, Is.EqualTo(0.5));
            Assert.That(mine.State.Position.Z, Is.EqualTo(3));

            Rigidbody theirs = _roots[0].GetComponent<Rigidbody>();
            Assert.That(theirs.inertiaTensor == new Vector3(13f / 4, 10f / 4, 5f / 4), Is.True);
            Assert.That(EngineVersions.Drag(theirs), Is.EqualTo(0.5f));
        }

        [Test]
        public void A_script_that_cannot_be_found_is_an_error()
        {
            LogAssert.Expect(LogType.Error, "The referenced script on this Behaviour (Game Object 'First') is missing!");
            string unknown = new string('9', 32);
            Load(Written().Replace(Guid("DefaultRigidbody"), unknown).Replace("{fileID: 204}\n---", "{fileID: 0}\n---"));

            Assert.That(_roots[0].GetComponents<Component>(), Has.Exactly(1).Null);
            Assert.That(_roots[0].GetComponent<DefaultRigidbody>() == null, Is.True);
        }

        [Test]
        public void A_field_that_a_script_does_not_have_is_an_error()
        {
            LogAssert.Expect(LogType.Error, new Regex("MyRigidbody has no field weight"));
            Load(Written().Replace("  mass: 1.25", "  weight: 1.25"));

            Assert.That(_roots[1].GetComponent<MyRigidbody>().mass, Is.EqualTo(1));
        }

        private static string Written() => File.ReadAllText(Path.Combine(Root.Path, "tests/UnityStubs/Headless/small.unity"))
            .Replace("DEFAULT_RIGIDBODY", Guid("DefaultRigidbody")).Replace("MY_RIGIDBODY", Guid("MyRigidbody"));

        private static string Guid(string script) => Regex.Match(
            File.ReadAllText(SceneLoader.InProject("Assets/MyRigidbody/Scripts/" + script + ".cs.meta")), "guid: ([0-9a-f]{32})").Groups[1].Value;

        private void Load(string text)
        {
            Directory.CreateDirectory(World.Folder);
            string path = Path.Combine(World.Folder, "small.unity");
            File.WriteAllText(path, text);
            World.Load("small", path);
            _roots = SceneManager.GetActiveScene().GetRootGameObjects();
        }
    }
}
