using System.Collections;
using System.Linq;
using NUnit.Framework;
using UnityEngine;
using UnityEngine.SceneManagement;
using UnityEngine.TestTools;

namespace RigidBodyDynamics.Scripts.Tests.Play
{
    /// <summary>All scenes load and play for ten seconds; an error in the console makes the test fail.</summary>
    public sealed class SceneTests : PlayTest
    {
        [UnityTest]
        public IEnumerator The_labs_scene_plays_ten_seconds() => Play("Lab", bodies: 2, theirs: 2);

        [UnityTest]
        public IEnumerator The_tumbling_slabs_play_ten_seconds() => Play("TumblingSlab", bodies: 4, theirs: 0);

        [UnityTest, Category("Touching")]
        public IEnumerator The_thrown_slabs_play_ten_seconds() => Play("ThrownSlabs", bodies: 0, theirs: 4);

        private IEnumerator Play(string scene, int bodies, int theirs)
        {
            SceneManager.LoadScene(scene);
            yield return null;
            yield return null;

            GameObject[] roots = SceneManager.GetActiveScene().GetRootGameObjects();
            DestroyAfterwards(roots);
            // a missing script is null here
            Assert.That(roots.SelectMany(root => root.GetComponentsInChildren<Component>(true)), Is.All.Not.Null);
            Experiment experiment = roots.Select(root => root.GetComponentInChildren<Experiment>()).Single(found => found != null);
            Assert.That(experiment.GetComponent<Panel>() != null, Is.True);
            Assert.That(experiment.Mine.Count, Is.EqualTo(bodies));
            Assert.That(experiment.Theirs.Count, Is.EqualTo(theirs));

            // the course's keys are for the lab's bodies; the slabs rotate freely
            int steps = experiment.Steps;
            while (experiment.Seconds < 10)
                yield return null;

            Assert.That(experiment.Steps, Is.GreaterThan(steps));
            foreach (MyRigidbody body in experiment.Mine)
            {
                Assert.That(body.IsReady && body.isActiveAndEnabled, Is.True, body.name);
                Assert.That(Numbers(body.State), Is.All.InRange(-1e3, 1e3), body.name);
            }
        }
    }
}
