using System.Linq;
using NUnit.Framework;
using UnityEditor;
using UnityEditor.SceneManagement;
using UnityEngine;

namespace RigidBodyDynamics.Scripts.Tests.Edit
{
    /// <summary>The scenes open in the editor.</summary>
    public sealed class SceneFileTests
    {
        [TestCase("Lab")]
        [TestCase("TumblingSlab")]
        [TestCase("ThrownSlabs")]
        public void A_scene_opens_with_all_its_scripts(string name)
        {
            UnityEngine.SceneManagement.Scene scene = EditorSceneManager.OpenScene("Assets/MyRigidbody/Scenes/" + name + ".unity");
            GameObject[] objects = scene.GetRootGameObjects()
                .SelectMany(root => root.GetComponentsInChildren<Transform>(true)).Select(found => found.gameObject).ToArray();

            Assert.That(objects.Length, Is.GreaterThan(4));
            Assert.That(objects.Sum(GameObjectUtility.GetMonoBehavioursWithMissingScriptCount), Is.Zero);
            Assert.That(objects.Count(found => found.GetComponent<Camera>() != null), Is.EqualTo(1));
            Assert.That(objects.Count(found => found.GetComponent<Light>() != null), Is.GreaterThan(0));
        }
    }
}
