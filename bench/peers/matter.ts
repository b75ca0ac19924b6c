import Matter, { type Body } from 'matter-js';
import { DEFAULT_BOX } from '../../engine/index.ts';
import type { Level } from '../../schema/index.ts';
import { Gun } from './gun.ts';
import { type Peer, type PeerOutcome, type PeerWorld, requireSupported } from './peer.ts';
import { touchables } from './touchables.ts';

/** matter-js counts time in ms: forces are in mass px/ms2, and velocities are set in px per 1/60 s whatever the step. */
const PER_SECOND_SQUARED = 1e-6;

/** matter-js. Its circles are polygons, which is how the engine makes them. */
export const matter: Peer = {
  name: 'matter-js',
  precision: 'double',
  async load() {},

  create(level: Level, rate: number): PeerWorld {
    requireSupported(level);
    const engine = Matter.Engine.create({ gravity: { x: 0, y: 0, scale: 0 }, enableSleeping: false });
    const { x, y, vx, vy } = level.astronaut;
    const astronaut = Matter.Bodies.rectangle(x, y, 2 * DEFAULT_BOX.halfWidth, 2 * DEFAULT_BOX.halfHeight, {
      isSensor: true,
      mass: 1,
      inertia: Number.POSITIVE_INFINITY,
      friction: 0,
      frictionAir: 0,
    });
    Matter.Body.setVelocity(astronaut, { x: vx / 60, y: vy / 60 });
    Matter.Composite.add(engine.world, astronaut);
    const ends = new Map<Body, PeerOutcome>();
    for (const circle of touchables(level)) {
      const body = Matter.Bodies.circle(circle.x, circle.y, circle.radius, { isSensor: true, isStatic: true });
      Matter.Composite.add(engine.world, body);
      ends.set(body, circle.ends);
    }
    let outcome: PeerOutcome = null;
    Matter.Events.on(engine, 'collisionStart', (event) => {
      for (const { bodyA, bodyB } of event.pairs) outcome ??= ends.get(bodyA) ?? ends.get(bodyB) ?? null;
    });
    const gun = new Gun(level);
    const deltaMs = 1000 / rate;
    let started = false;
    return {
      step(held) {
        gun.aim(astronaut.position.x, astronaut.position.y, held);
        if (gun.lost) outcome ??= 'lost';
        if (held) Matter.Body.setAngle(astronaut, gun.angle);
        astronaut.force.x = gun.ax * astronaut.mass * PER_SECOND_SQUARED;
        astronaut.force.y = gun.ay * astronaut.mass * PER_SECOND_SQUARED;
        Matter.Engine.update(engine, deltaMs);
        started = true;
      },
      read(out) {
        out[0] = astronaut.position.x;
        out[1] = astronaut.position.y;
        // a Verlet body has no velocity, only the displacement of its last step
        out[2] = started ? (astronaut.position.x - astronaut.positionPrev.x) * rate : vx;
        out[3] = started ? (astronaut.position.y - astronaut.positionPrev.y) * rate : vy;
      },
      get outcome() {
        return outcome;
      },
      dispose() {
        Matter.Engine.clear(engine);
      },
    };
  },
};
