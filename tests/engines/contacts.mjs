// Boxes in PhysX that touch a floor, walls and each other, driven by another program: each line of the input is one request, each
// line of the output its answer, both JSON. All is as Unity has it: its contact offset, bounce threshold, iterations and solver, no gyroscopic
// forces.
//   {"gravity": [x,y,z], "friction", "restitution", "room": half an edge or null, "floor": true, "bodies": [{"edges": [], "mass", "position": [],
//    "velocity": [], "spin": [], "sleepThreshold", "angularDrag"}], "hinge": true}             begins a new world; answers the engine's name
//   {"set": [[body, x, y, z], ...], "torque": [[body, x, y, z], ...], "step": seconds}           angular velocities, torques, then a step
// A step answers for each body [position, rotation (x, y, z, w), velocity, angular velocity, asleep], fourteen numbers.
import { createInterface } from "node:readline";
import { startPhysX } from "./physx.mjs";

const { px, physics, tolerances, name } = await startPhysX();
const vector = ([x, y, z]) => new px.PxVec3(x, y, z);
const still = new px.PxQuat(0, 0, 0, 1);
const shapeFlags = new px.PxShapeFlags(px.PxShapeFlagEnum.eSIMULATION_SHAPE);
const touching = new px.PxFilterData(1, 1, 0, 0);
const contactOffset = 0.01;
const thickness = 10;

let scene;
let bodies;

function box(actor, edges, material) {
  const shape = physics.createShape(new px.PxBoxGeometry(...edges.map((edge) => edge / 2)), material, true, shapeFlags);
  shape.setSimulationFilterData(touching);
  shape.setContactOffset(contactOffset);
  actor.attachShape(shape);
}

function wall(position, edges, material) {
  const actor = physics.createRigidStatic(new px.PxTransform(vector(position), still));
  box(actor, edges, material);
  scene.addActor(actor);
}

function begin({ gravity, friction, restitution, room, floor, bodies: described, hinge }) {
  const about = new px.PxSceneDesc(tolerances);
  about.gravity = vector(gravity);
  about.cpuDispatcher = px.DefaultCpuDispatcherCreate(0);
  about.filterShader = px.DefaultFilterShader();
  about.solverType = px.PxSolverTypeEnum.ePGS;
  about.bounceThresholdVelocity = 2;
  scene?.release();
  scene = physics.createScene(about);
  const material = physics.createMaterial(friction, friction, restitution);
  const wide = [100, 100, 100];
  for (let axis = 0; axis < 3; axis++) {
    for (const side of [-1, 1]) {
      if (room || (floor && axis === 1 && side === -1)) {
        const inner = room ?? 0;
        wall([0, 0, 0].with(axis, side * (inner + thickness / 2)), wide.with(axis, thickness), material);
      }
    }
  }
  bodies = described.map(({ edges, mass, position, velocity, spin, sleepThreshold, angularDrag }) => {
    const body = physics.createRigidDynamic(new px.PxTransform(vector(position), still));
    box(body, edges, material);
    const squares = edges.map((edge) => edge * edge);
    const sum = squares[0] + squares[1] + squares[2];
    body.setMass(mass);
    body.setMassSpaceInertiaTensor(vector(squares.map((square) => (mass / 12) * (sum - square))));
    body.setAngularDamping(angularDrag);
    body.setLinearDamping(0);
    body.setMaxAngularVelocity(1000);
    body.setSleepThreshold(sleepThreshold);
    body.setSolverIterationCounts(6, 1);
    scene.addActor(body);
    body.setLinearVelocity(vector(velocity));
    body.setAngularVelocity(vector(spin));
    return body;
  });
  if (hinge) {
    const here = (at) => new px.PxTransform(vector(at), still);
    px.RevoluteJointCreate(physics, null, here(described[0].position), bodies[0], here([0, 0, 0]));
  }
  return { name, inertia: bodies.map((body) => numbers(body.getMassSpaceInertiaTensor())) };
}

const numbers = ({ x, y, z }) => [x, y, z];

function step({ set = [], torque = [], step: seconds }) {
  for (const [i, ...w] of set) {
    bodies[i].setAngularVelocity(vector(w));
  }
  for (const [i, ...t] of torque) {
    bodies[i].addTorque(vector(t));
  }
  scene.simulate(seconds);
  scene.fetchResults(true);
  return bodies.map((body) => {
    const { p, q } = body.getGlobalPose();
    return [...numbers(p), ...numbers(q), q.w, ...numbers(body.getLinearVelocity()), ...numbers(body.getAngularVelocity()), body.isSleeping() ? 1 : 0];
  });
}

for await (const line of createInterface({ input: process.stdin })) {
  const request = JSON.parse(line);
  process.stdout.write(`${JSON.stringify("step" in request ? step(request) : begin(request))}\n`);
}
process.exit(0);
