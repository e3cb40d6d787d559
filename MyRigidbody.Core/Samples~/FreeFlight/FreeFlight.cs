using RigidBodyDynamics;
using UnityEngine;

/// <summary>A slab, thrown about its middle axis, that flips again and again. Put it on a cube and press Play.</summary>
public sealed class FreeFlight : MonoBehaviour
{
    private Simulation _simulation;

    private void Start()
    {
        Vector3 edges = transform.localScale = new Vector3(1, 0.4f, 0.1f), here = transform.position;
        BodyDescription slab = new BodyDescription("slab", Solids.Box(1, new Vector3d(edges.x, edges.y, edges.z)))
        {
            Rule = Rules.Exact,
            Start = new BodyState(new Vector3d(here.x, here.y, here.z), Quaterniond.Identity, Vector3d.Zero, new Vector3d(0.02, 6, 0.01)),
        };
        _simulation = new Simulation(TimeSteps.Every(0.02), slab);
    }

    // takes the steps that the frame's time contains, and draws the rest by interpolation
    private void Update()
    {
        _simulation.Advance(Time.deltaTime);
        BodyState pose = _simulation.Bodies[0].Between(_simulation.Alpha);
        Vector3d x = pose.Position;
        Quaterniond q = pose.Orientation;
        transform.SetPositionAndRotation(new Vector3((float)x.X, (float)x.Y, (float)x.Z), new Quaternion((float)q.X, (float)q.Y, (float)q.Z, (float)q.W));
    }
}
