import * as p2 from 'p2-es';
import { DEFAULT_BOX } from '../../engine/index.ts';
import type { Level } from '../../schema/index.ts';
import { Gun } from './gun.ts';
import { type Peer, type PeerOutcome, type PeerWorld, requireSupported } from './peer.ts';
import { touchables } from './touchables.ts';

/**
 * p2 (its maintained port p2-es), used like in the original's first prototype: a force towards the asteroid, set in each step.
 */
export const p2es: Peer = {
  name: 'p2-es',
  precision: 'double',
  async load() {},

  create(level: Level, rate: number): PeerWorld {
    requireSupported(level);
    const world = new p2.World({ gravity: [0, 0] });
    world.sleepMode = p2.World.NO_SLEEPING;
    world.applyGravity = false;
    world.applyDamping = false;
    world.applySpringForces = false;
    const { x, y, vx, vy } = level.astronaut;
    const astronaut = new p2.Body({
      mass: 1,
      position: [x, y],
      velocity: [vx, vy],
      fixedRotation: true,
      damping: 0,
      angularDamping: 0,
    });
    astronaut.addShape(new p2.Box({ width: 2 * DEFAULT_BOX.halfWidth, height: 2 * DEFAULT_BOX.halfHeight, sensor: true }));
    world.addBody(astronaut);
    const ends = new Map<p2.Body, PeerOutcome>();
    for (const circle of touchables(level)) {
      const body = new p2.Body({ mass: 0, position: [circle.x, circle.y] });
      body.addShape(new p2.Circle({ radius: circle.radius, sensor: true }));
      world.addBody(body);
      ends.set(body, circle.ends);
    }
    let outcome: PeerOutcome = null;
    world.on('beginContact', (event) => {
      outcome ??= ends.get(event.bodyA) ?? ends.get(event.bodyB) ?? null;
    });
    const gun = new Gun(level);
    const dt = 1 / rate;
    return {
      step(held) {
        gun.aim(astronaut.position[0], astronaut.position[1], held);
        if (gun.lost) outcome ??= 'lost';
        if (held) astronaut.angle = gun.angle;
        astronaut.force[0] = gun.ax;
        astronaut.force[1] = gun.ay;
        world.step(dt);
      },
      read(out) {
        out[0] = astronaut.position[0];
        out[1] = astronaut.position[1];
        out[2] = astronaut.velocity[0];
        out[3] = astronaut.velocity[1];
      },
      get outcome() {
        return outcome;
      },
      dispose() {
        world.clear();
      },
    };
  },
};
