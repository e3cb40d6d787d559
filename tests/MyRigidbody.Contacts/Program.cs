using RigidBodyDynamics.Contacts;

// What ExactRotation does to bodies of the real PhysX, figures and bounds. Usage: MyRigidbody.Contacts [FOLDER of tests/engines]
// With --poses FILE it writes how PhysX plays the package's scene ThrownSlabs instead.
using PhysX engine = new(args.Length > 0 ? args[0] : "tests/engines");
if (args is [_, "--poses", string poses])
{
    ThrownSlabs.Write(engine, poses);
    return 0;
}

bool holds = Flight.Holds(engine);
holds &= Bounce.Holds(engine);
holds &= Rest.Holds(engine);
holds &= Hinge.Holds(engine);
Console.WriteLine($"\n{engine.Name}, 50 steps a second: {(holds ? "all bounds hold" : "A BOUND IS BROKEN")}");
return holds ? 0 : 1;
