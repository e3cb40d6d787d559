using System;
using System.IO;
using System.Linq;
using System.Text.RegularExpressions;
using NUnit.Framework;
using RigidBodyDynamics.Engine;

namespace RigidBodyDynamics.Scripts.Tests.Headless
{
    /// <summary>The pictures of the scenes show the panel as it is drawn: row by row, a tab between the controls of a row.</summary>
    public sealed class PanelPictureTests
    {
        [TearDown]
        public void SpeakEnglish() => Words.AreChinese = false;

        [TestCase("Lab", false, "lab")]
        [TestCase("Lab", true, "lab.zh")]
        [TestCase("TumblingSlab", false, "slab")]
        public void Picture_has_the_rows_that_are_drawn(string scene, bool isChinese, string file)
        {
            Laboratory.Load(scene);
            Words.AreChinese = isChinese;
            Player.Frame(0.02);
            Player.Frame(0.02);
            string rows = string.Concat(Gui.Rows.Where(row => row.All(control => control.Kind != "tag"))
                .Select(row => string.Join("\t", row.Select(control => control.Kind + ":" + Timeless(control.Text))) + "\n"));
            string path = Path.Combine(Root.Path, "tests", "MyRigidbody.UnityFiles", "Drawing", "panel-" + file + ".txt");
            if (Environment.GetEnvironmentVariable("MYRIGIDBODY_WRITE") == "1")
                File.WriteAllText(path, rows);

            Assert.That(rows, Is.EqualTo(File.ReadAllText(path)), "MYRIGIDBODY_WRITE=1 writes them anew: draw the pictures then");
        }

        // a time is of this machine
        private static string Timeless(string text) => Regex.Replace(text, @"^[0-9]+ ns$", "… ns");
    }
}
