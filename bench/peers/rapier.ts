import RAPIER from '@dimforge/rapier2d-deterministic-compat';
import { DEFAULT_BOX } from '../../engine/index.ts';
import type { Level } from '../../schema/index.ts';
import { Gun } from './gun.ts';
import { type Peer, type PeerOutcome, type PeerWorld, requireSupported } from './peer.ts';
import { touchables } from './touchables.ts';

/** Rapier's deterministic build: Rust in WebAssembly, single precision. */
export const rapier: Peer = {
  name: 'Rapier',
  precision: 'single',

  async load() {
    await RAPIER.init();
  },

  create(level: Level, rate: number): PeerWorld {
    requireSupported(level);
    const world = new RAPIER.World({ x: 0, y: 0 });
    world.timestep = 1 / rate;
    // tolerances scale with the size of objects: hers is about half of this
    world.lengthUnit = 50;
    // sub-steps are for contacts, and there are none to solve; the force is constant over all of them, so more make the motion
    // less accurate
    world.numSolverIterations = 1;
    const { x, y, vx, vy } = level.astronaut;
    const astronaut = world.createRigidBody(
      RAPIER.RigidBodyDesc.dynamic()
        .setTranslation(x, y)
        .setLinvel(vx, vy)
        .lockRotations()
        .setLinearDamping(0)
        .setCanSleep(false),
    );
    world.createCollider(
      RAPIER.ColliderDesc.cuboid(DEFAULT_BOX.halfWidth, DEFAULT_BOX.halfHeight)
        .setSensor(true)
        .setMass(1)
        .setActiveEvents(RAPIER.ActiveEvents.COLLISION_EVENTS),
      astronaut,
    );
    const ends = new Map<number, PeerOutcome>();
    for (const circle of touchables(level)) {
      const body = world.createRigidBody(RAPIER.RigidBodyDesc.fixed().setTranslation(circle.x, circle.y));
      ends.set(world.createCollider(RAPIER.ColliderDesc.ball(circle.radius).setSensor(true), body).handle, circle.ends);
    }
    const events = new RAPIER.EventQueue(true);
    let outcome: PeerOutcome = null;
    const touch = (a: number, b: number, started: boolean): void => {
      if (started) outcome ??= ends.get(a) ?? ends.get(b) ?? null;
    };
    const gun = new Gun(level);
    const force = { x: 0, y: 0 };
    return {
      step(held) {
        const at = astronaut.translation();
        gun.aim(at.x, at.y, held);
        if (gun.lost) outcome ??= 'lost';
        // a force stays until it is reset
        astronaut.resetForces(false);
        if (held) {
          astronaut.setRotation(gun.angle, false);
          force.x = gun.ax;
          force.y = gun.ay;
          astronaut.addForce(force, false);
        }
        world.step(events);
        events.drainCollisionEvents(touch);
      },
      read(out) {
        const at = astronaut.translation();
        const velocity = astronaut.linvel();
        out[0] = at.x;
        out[1] = at.y;
        out[2] = velocity.x;
        out[3] = velocity.y;
      },
      get outcome() {
        return outcome;
      },
      dispose() {
        events.free();
        world.free();
      },
    };
  },
};
