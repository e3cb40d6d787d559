// A world of each engine: bodies of principal moments (1, 2, 3) and mass 1 that turn freely, far from each other, with
// nothing to collide with. What an engine adds of itself (gravity, damping, sleep, a limit of spin) is switched off, its
// gyroscopic term on where there is one; all else is as it comes. Each gives step(dt) and the orientation of the first body.
import { readFile } from "node:fs/promises";
import { startPhysX } from "./physx.mjs";

const moments = { x: 1, y: 2, z: 3 };
const spin = { x: 1, y: 1.1, z: 0.9 };
const place = (i) => ({ x: 10 * (i % 32), y: 10 * Math.floor(i / 32), z: 0 });
const indices = (count) => Array.from({ length: count }, (_, i) => i);
const file = (path) => new URL(`node_modules/${path}`, import.meta.url);
const versionOf = async (name) => JSON.parse(await readFile(file(`${name}/package.json`))).version;

async function physX() {
  const enableGyroscopicForces = 1 << 10; // PxRigidBodyFlag has it, this module's list of names has not
  const { px, physics, tolerances, name } = await startPhysX();
  return {
    name,
    world(count) {
      const about = new px.PxSceneDesc(tolerances);
      about.cpuDispatcher = px.DefaultCpuDispatcherCreate(0);
      about.filterShader = px.DefaultFilterShader();
      const scene = physics.createScene(about);
      const bodies = indices(count).map((i) => {
        const { x, y, z } = place(i);
        const body = physics.createRigidDynamic(new px.PxTransform(new px.PxVec3(x, y, z), new px.PxQuat(0, 0, 0, 1)));
        body.setMass(1);
        body.setMassSpaceInertiaTensor(new px.PxVec3(moments.x, moments.y, moments.z));
        body.setRigidBodyFlag(enableGyroscopicForces, true);
        body.setAngularDamping(0);
        body.setMaxAngularVelocity(1000);
        body.setSleepThreshold(0);
        scene.addActor(body);
        body.setAngularVelocity(new px.PxVec3(spin.x, spin.y, spin.z));
        return body;
      });
      return {
        step(dt) {
          scene.simulate(dt);
          scene.fetchResults(true);
        },
        orientation: () => bodies[0].getGlobalPose().q,
      };
    },
  };
}

async function jolt() {
  const j = await (await import("jolt-physics")).default();
  return {
    name: `Jolt (jolt-physics ${await versionOf("jolt-physics")})`,
    world(count) {
      const settings = new j.JoltSettings();
      const layers = new j.BroadPhaseLayerInterfaceTable(1, 1);
      layers.MapObjectToBroadPhaseLayer(0, new j.BroadPhaseLayer(0));
      settings.mBroadPhaseLayerInterface = layers;
      settings.mObjectLayerPairFilter = new j.ObjectLayerPairFilterTable(1);
      settings.mObjectVsBroadPhaseLayerFilter = new j.ObjectVsBroadPhaseLayerFilterTable(layers, 1, settings.mObjectLayerPairFilter, 1);
      const world = new j.JoltInterface(settings);
      const system = world.GetPhysicsSystem();
      system.SetGravity(new j.Vec3(0, 0, 0));
      const bodies = indices(count).map((i) => {
        const { x, y, z } = place(i);
        const about = new j.BodyCreationSettings(new j.SphereShape(0.5), new j.RVec3(x, y, z), new j.Quat(0, 0, 0, 1), j.EMotionType_Dynamic, 0);
        about.mOverrideMassProperties = j.EOverrideMassProperties_MassAndInertiaProvided;
        about.mMassPropertiesOverride.mMass = 1;
        about.mMassPropertiesOverride.mInertia.SetDiagonal3(new j.Vec3(moments.x, moments.y, moments.z));
        about.mApplyGyroscopicForce = true;
        about.mAngularDamping = 0;
        about.mLinearDamping = 0;
        about.mAllowSleeping = false;
        about.mMaxAngularVelocity = 1000;
        about.mAngularVelocity = new j.Vec3(spin.x, spin.y, spin.z);
        const body = system.GetBodyInterface().CreateBody(about);
        system.GetBodyInterface().AddBody(body.GetID(), j.EActivation_Activate);
        return body;
      });
      return {
        step: (dt) => world.Step(dt, 1),
        orientation() {
          const q = bodies[0].GetRotation();
          return { x: q.GetX(), y: q.GetY(), z: q.GetZ(), w: q.GetW() };
        },
      };
    },
  };
}

async function rapier() {
  const r = await import("@dimforge/rapier3d-compat");
  await r.init();
  return {
    name: `Rapier (rapier3d-compat ${await versionOf("@dimforge/rapier3d-compat")})`,
    world(count) {
      const world = new r.World({ x: 0, y: 0, z: 0 });
      const bodies = indices(count).map((i) => {
        const { x, y, z } = place(i);
        return world.createRigidBody(r.RigidBodyDesc.dynamic().setTranslation(x, y, z).setAngvel(spin).setCanSleep(false)
          .setAdditionalMassProperties(1, { x: 0, y: 0, z: 0 }, moments, { x: 0, y: 0, z: 0, w: 1 }));
      });
      return {
        step(dt) {
          world.timestep = dt;
          world.step();
        },
        orientation: () => bodies[0].rotation(),
      };
    },
  };
}

async function havok() {
  const hp = await (await import("@babylonjs/havok")).default({ wasmBinary: await readFile(file("@babylonjs/havok/lib/esm/HavokPhysics.wasm")) });
  return {
    name: `Havok (@babylonjs/havok ${await versionOf("@babylonjs/havok")})`,
    world(count) {
      const [, world] = hp.HP_World_Create();
      hp.HP_World_SetGravity(world, [0, 0, 0]);
      hp.HP_World_SetIdealStepTime(world, 0.02);
      const bodies = indices(count).map((i) => {
        const { x, y, z } = place(i);
        const [, body] = hp.HP_Body_Create();
        hp.HP_Body_SetMotionType(body, hp.MotionType.DYNAMIC);
        hp.HP_Body_SetPosition(body, [x, y, z]);
        hp.HP_Body_SetMassProperties(body, [[0, 0, 0], 1, [moments.x, moments.y, moments.z], [0, 0, 0, 1]]);
        hp.HP_Body_SetAngularDamping(body, 0);
        hp.HP_Body_SetActivationControl(body, hp.ActivationControl.ALWAYS_ACTIVE);
        hp.HP_World_AddBody(world, body, false);
        hp.HP_Body_SetAngularVelocity(body, [spin.x, spin.y, spin.z]);
        return body;
      });
      return {
        step: (dt) => hp.HP_World_Step(world, dt),
        orientation() {
          const [, [x, y, z, w]] = hp.HP_Body_GetOrientation(bodies[0]);
          return { x, y, z, w };
        },
      };
    },
  };
}

async function muJoCo() {
  const m = await (await import("@mujoco/mujoco")).default({ wasmBinary: await readFile(file("@mujoco/mujoco/mujoco.wasm")) });
  const of = (integrator) => ({
    name: `MuJoCo ${m.mj_versionString()} ${integrator}`,
    world(count) {
      const bodies = indices(count).map(place).map(({ x, y, z }) =>
        `<body pos="${x} ${y} ${z}"><freejoint/><inertial pos="0 0 0" mass="1" diaginertia="1 2 3"/></body>`);
      const model = m.MjModel.from_xml_string(
        `<mujoco><size memory="200M"/><option timestep="0.02" gravity="0 0 0" integrator="${integrator}"/><worldbody>${bodies.join("")}</worldbody></mujoco>`);
      const data = new m.MjData(model);
      for (let i = 0; i < count; i++) {
        data.qvel.set([spin.x, spin.y, spin.z], 6 * i + 3);
      }
      return {
        step: () => m.mj_step(model, data),
        orientation() {
          const [w, x, y, z] = data.qpos.slice(3, 7);
          return { x, y, z, w };
        },
      };
    },
  });
  return [of("Euler"), of("implicitfast"), of("RK4")];
}

async function cannon() {
  const c = await import("cannon-es");
  return {
    name: `cannon-es ${await versionOf("cannon-es")}`,
    world(count) {
      const world = new c.World();
      const bodies = indices(count).map((i) => {
        const { x, y, z } = place(i);
        const body = new c.Body({ mass: 1, position: new c.Vec3(x, y, z), angularDamping: 0, linearDamping: 0, allowSleep: false });
        body.inertia.set(moments.x, moments.y, moments.z);
        body.invInertia.set(1 / moments.x, 1 / moments.y, 1 / moments.z);
        body.updateInertiaWorld(true);
        body.angularVelocity.set(spin.x, spin.y, spin.z);
        world.addBody(body);
        return body;
      });
      return { step: (dt) => world.step(dt), orientation: () => bodies[0].quaternion };
    },
  };
}

/** Every engine, started one after the other. */
export async function engines() {
  const all = [];
  for (const start of [physX, jolt, rapier, havok, muJoCo, cannon]) {
    all.push(...[await start()].flat());
  }
  return all;
}
