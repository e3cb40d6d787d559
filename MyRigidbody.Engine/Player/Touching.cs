using System;
using System.Collections.Generic;
using UnityEngine;

namespace RigidBodyDynamics.Engine
{
    /// <summary>
    /// Finds bodies that would collide in an engine. The stand-in has no contacts: bodies pass through each other, so a motion in which two of them
    /// would touch is not Unity's. It tests axis-aligned boxes of their colliders, and so finds contacts somewhat too early.
    /// </summary>
    public static class Touching
    {
        private static readonly HashSet<(Collider, Collider)> Ignored = new HashSet<(Collider, Collider)>();
        private static readonly List<string> Found = new List<string>();

        /// <summary>True while contacts are searched.</summary>
        public static bool IsWatched { get; set; }

        /// <summary>The pairs that have touched, by name, each once.</summary>
        public static IReadOnlyList<string> Pairs => Found;

        /// <summary>True where a test expects bodies to touch.</summary>
        public static bool IsExpected { get; set; }

        internal static void Reset()
        {
            Ignored.Clear();
            Found.Clear();
            IsExpected = false;
        }

        internal static void Ignore(Collider a, Collider b, bool ignore)
        {
            foreach ((Collider, Collider) pair in new[] { (a, b), (b, a) })
            {
                if (ignore)
                    Ignored.Add(pair);
                else
                    Ignored.Remove(pair);
            }
        }

        /// <summary>To be called after every step of physics.</summary>
        internal static void Look()
        {
            if (!IsWatched)
                return;

            List<BoxCollider> boxes = new List<BoxCollider>();
            foreach (GameObject holder in World.Objects)
            {
                foreach (BoxCollider box in holder.activeInHierarchy ? holder.GetComponents<BoxCollider>() : new BoxCollider[0])
                {
                    if (box.enabled)
                        boxes.Add(box);
                }
            }

            for (int i = 0; i < boxes.Count; i++)
            {
                for (int j = 0; j < i; j++)
                    Look(boxes[j], boxes[i]);
            }
        }

        private static void Look(BoxCollider a, BoxCollider b)
        {
            Rigidbody bodyA = a.GetComponentInParent<Rigidbody>(), bodyB = b.GetComponentInParent<Rigidbody>();
            string pair = a.name + " and " + b.name;
            // an object without a Rigidbody does not move, and parts of one body do not collide
            if (bodyA != bodyB && !Ignored.Contains((a, b)) && !Found.Contains(pair) && Overlap(a, b))
                Found.Add(pair);
        }

        private static bool Overlap(BoxCollider a, BoxCollider b)
        {
            Vector3 apart = Middle(a) - Middle(b), reach = Reach(a) + Reach(b);
            return Math.Abs(apart.x) < reach.x && Math.Abs(apart.y) < reach.y && Math.Abs(apart.z) < reach.z;
        }

        private static Vector3 Middle(BoxCollider box) =>
            box.transform.position + box.transform.rotation * Vector3.Scale(box.transform.lossyScale, box.center);

        private static Vector3 Reach(BoxCollider box)
        {
            Vector3 half = 0.5f * Vector3.Scale(box.transform.lossyScale, box.size), reach = Vector3.zero;
            foreach (Vector3 edge in new[] { half.x * Vector3.right, half.y * Vector3.up, half.z * Vector3.forward })
            {
                Vector3 turned = box.transform.rotation * edge;
                reach += new Vector3(Math.Abs(turned.x), Math.Abs(turned.y), Math.Abs(turned.z));
            }

            return reach;
        }
    }
}
