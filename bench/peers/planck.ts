import { Box, Circle, Settings, Vec2, World } from 'planck';
import { DEFAULT_BOX } from '../../engine/index.ts';
import { DEFAULT_RULES, type Level } from '../../schema/index.ts';
import { Gun } from './gun.ts';
import { type Peer, type PeerOutcome, type PeerWorld, requireSupported } from './peer.ts';
import { touchables } from './touchables.ts';

/** Box2D's tolerances are made for bodies of 0.1 to 10 m; at this scale she is 0.4 x 0.64 m. */
const PX_PER_METRE = 50;

/** planck, the port of Box2D 2 to JavaScript. */
export const planck: Peer = {
  name: 'planck',
  precision: 'double',

  async load() {
    // by default bodies move at most 2 m per step
    Settings.maxTranslation = DEFAULT_RULES.speedLimit;
  },

  create(level: Level, rate: number): PeerWorld {
    requireSupported(level);
    const world = new World({ gravity: new Vec2(0, 0), allowSleep: false });
    const { x, y, vx, vy } = level.astronaut;
    const astronaut = world.createBody({
      type: 'dynamic',
      position: new Vec2(x / PX_PER_METRE, y / PX_PER_METRE),
      linearVelocity: new Vec2(vx / PX_PER_METRE, vy / PX_PER_METRE),
      linearDamping: 0,
      fixedRotation: true,
    });
    const width = DEFAULT_BOX.halfWidth / PX_PER_METRE;
    const height = DEFAULT_BOX.halfHeight / PX_PER_METRE;
    astronaut.createFixture({ shape: new Box(width, height), density: 1 / (4 * width * height), isSensor: true });
    for (const circle of touchables(level)) {
      const body = world.createBody({ type: 'static', position: new Vec2(circle.x / PX_PER_METRE, circle.y / PX_PER_METRE) });
      body.createFixture({ shape: new Circle(circle.radius / PX_PER_METRE), isSensor: true, userData: circle.ends });
    }
    let outcome: PeerOutcome = null;
    world.on('begin-contact', (contact) => {
      outcome ??=
        ((contact.getFixtureA().getUserData() ?? contact.getFixtureB().getUserData()) as PeerOutcome | undefined) ?? null;
    });
    const gun = new Gun(level);
    const dt = 1 / rate;
    const mass = astronaut.getMass();
    const force = new Vec2(0, 0);
    return {
      step(held) {
        const at = astronaut.getPosition();
        gun.aim(at.x * PX_PER_METRE, at.y * PX_PER_METRE, held);
        if (gun.lost) outcome ??= 'lost';
        if (held) {
          astronaut.setAngle(gun.angle);
          force.set((gun.ax * mass) / PX_PER_METRE, (gun.ay * mass) / PX_PER_METRE);
          astronaut.applyForceToCenter(force, true);
        }
        world.step(dt);
      },
      read(out) {
        const at = astronaut.getPosition();
        const velocity = astronaut.getLinearVelocity();
        out[0] = at.x * PX_PER_METRE;
        out[1] = at.y * PX_PER_METRE;
        out[2] = velocity.x * PX_PER_METRE;
        out[3] = velocity.y * PX_PER_METRE;
      },
      get outcome() {
        return outcome;
      },
      dispose() {},
    };
  },
};
