using System.Collections.Concurrent;
using System.Text;
using RigidBodyDynamics.StudentScripts;

namespace RigidBodyDynamics.Tests.StudentScripts;

/// <summary>Warm processes for the tests of scripts: as many as there are tests at once, each used by one at a time.</summary>
internal static class Runner
{
    private static readonly ConcurrentBag<ScriptRunner> Warm = [];

    public static ScriptReport Run(string script) => InTurn(script).Single();

    public static ScriptReport Run(params (string Name, byte[] Bytes)[] files) => On(runner => runner.Run(Files(files)));

    /// <summary>One after another in the same process, where what one does to it the next would feel.</summary>
    public static ScriptReport[] InTurn(params string[] scripts) => On(runner => scripts.Select(script => runner.Run(Files(("MyRigidbody.cs", Encoding.UTF8.GetBytes(script))))).ToArray());

    /// <summary>A process for as long as something takes.</summary>
    public static T On<T>(Func<ScriptRunner, T> use)
    {
        ScriptRunner runner = Warm.TryTake(out ScriptRunner? idle) ? idle : new ScriptRunner();
        try
        {
            return use(runner);
        }
        finally
        {
            Warm.Add(runner);
        }
    }

    public static ScriptFile[] Files(params (string Name, byte[] Bytes)[] files) => [.. files.Select(file => new ScriptFile(file.Name, file.Bytes))];

    /// <summary>A right script with something put into its class, its Start, its Update and above it.</summary>
    public static string With(string members = "", string start = "", string update = "", string above = "") => $$"""
        using System;
        using System.Collections.Generic;
        using System.Linq;
        using UnityEngine;
        {{above}}
        public class MyRigidbody : MonoBehaviour
        {
            public float mass = 1, dt = 0.02f;
            Vector3 force, torque, v, w;
            Matrix4x4 I_ref;
            {{members}}

            void Start()
            {
                {{start}}
                Vector3[] vertices = GetComponent<MeshFilter>().mesh.vertices;
                foreach (Vector3 r in vertices)
                    for (int i = 0; i < 3; i++)
                        for (int j = 0; j < 3; j++)
                            I_ref[i, j] += mass / vertices.Length * ((i == j ? Vector3.Dot(r, r) : 0) - r[i] * r[j]);
                I_ref[3, 3] = 1;
            }

            void Update()
            {
                torque = Vector3.zero;
                if (Input.GetKey(KeyCode.R))
                    torque = Vector3.one * Mathf.Sin(Time.time);
                force = Vector3.zero;
                if (Input.GetKey(KeyCode.LeftArrow)) force += new Vector3(-5, 0, 0);
                if (Input.GetKey(KeyCode.RightArrow)) force += new Vector3(5, 0, 0);
                if (Input.GetKey(KeyCode.UpArrow)) force += new Vector3(0, 5, 0);
                if (Input.GetKey(KeyCode.DownArrow)) force += new Vector3(0, -5, 0);
                {{update}}
                v += force / mass * dt;
                Matrix4x4 R = Matrix4x4.Rotate(transform.rotation);
                w += dt * (R * I_ref * R.transpose).inverse.MultiplyVector(torque);
                transform.position += v * dt;
                Quaternion q = transform.rotation, d = new Quaternion(w.x, w.y, w.z, 0) * q;
                float h = dt / 2;
                transform.rotation = new Quaternion(q.x + h * d.x, q.y + h * d.y, q.z + h * d.z, q.w + h * d.w);
                v *= 0.98f;
                w *= 0.98f;
            }
        }
        """;
}
