import loadBox2D from 'box2d3-wasm';
import { DEFAULT_BOX } from '../../engine/index.ts';
import type { Level } from '../../schema/index.ts';
import { Gun } from './gun.ts';
import { type Peer, type PeerOutcome, type PeerWorld, requireSupported } from './peer.ts';
import { touchables } from './touchables.ts';

type Box2D = Awaited<ReturnType<typeof loadBox2D>>;

/** As for planck: Box2D's tolerances are made for bodies of 0.1 to 10 m. */
const PX_PER_METRE = 50;

/**
 * Sub-steps are for contacts, and there are none to solve. The force is constant over all of them, so more make the motion less
 * accurate.
 */
const SUB_STEPS = 1;

let box2d: Box2D | null = null;

/** Box2D 3, C in WebAssembly, single precision. */
export const box2d3: Peer = {
  name: 'Box2D 3',
  precision: 'single',

  async load() {
    box2d ??= await loadBox2D();
  },

  create(level: Level, rate: number): PeerWorld {
    requireSupported(level);
    if (box2d === null) throw new Error('load() first');
    const b2 = box2d;
    const point = (px: number, py: number) => new b2.b2Vec2(px / PX_PER_METRE, py / PX_PER_METRE);
    const worldDef = b2.b2DefaultWorldDef();
    worldDef.gravity = new b2.b2Vec2(0, 0);
    worldDef.enableSleep = false;
    const world = b2.b2CreateWorld(worldDef);

    const { x, y, vx, vy } = level.astronaut;
    const bodyDef = b2.b2DefaultBodyDef();
    bodyDef.type = b2.b2BodyType.b2_dynamicBody;
    bodyDef.position = point(x, y);
    bodyDef.linearVelocity = point(vx, vy);
    bodyDef.linearDamping = 0;
    bodyDef.enableSleep = false;
    const astronaut = b2.b2CreateBody(world, bodyDef);
    const boxDef = b2.b2DefaultShapeDef();
    boxDef.isSensor = true;
    boxDef.enableSensorEvents = true;
    const width = DEFAULT_BOX.halfWidth / PX_PER_METRE;
    const height = DEFAULT_BOX.halfHeight / PX_PER_METRE;
    boxDef.density = 1 / (4 * width * height);
    b2.b2CreatePolygonShape(astronaut, boxDef, b2.b2MakeBox(width, height));

    const endings: { index: number; ends: PeerOutcome }[] = [];
    for (const circle of touchables(level)) {
      const def = b2.b2DefaultBodyDef();
      def.position = point(circle.x, circle.y);
      const shapeDef = b2.b2DefaultShapeDef();
      // sensors do not detect sensors: she is the sensor, what she touches is not
      shapeDef.enableSensorEvents = true;
      const shape = new b2.b2Circle();
      shape.center = new b2.b2Vec2(0, 0);
      shape.radius = circle.radius / PX_PER_METRE;
      const id = b2.b2CreateCircleShape(b2.b2CreateBody(world, def), shapeDef, shape);
      endings.push({ index: id.index1, ends: circle.ends });
    }

    const gun = new Gun(level);
    const mass = b2.b2Body_GetMass(astronaut);
    const force = new b2.b2Vec2(0, 0);
    const rotation = new b2.b2Rot();
    const dt = 1 / rate;
    let outcome: PeerOutcome = null;
    return {
      step(held) {
        const at = b2.b2Body_GetPosition(astronaut);
        gun.aim(at.x * PX_PER_METRE, at.y * PX_PER_METRE, held);
        if (gun.lost) outcome ??= 'lost';
        if (held) {
          rotation.SetAngle(gun.angle);
          b2.b2Body_SetTransform(astronaut, at, rotation);
          force.Set((gun.ax * mass) / PX_PER_METRE, (gun.ay * mass) / PX_PER_METRE);
          b2.b2Body_ApplyForceToCenter(astronaut, force, true);
        }
        // what embind returns stays in its heap until it is deleted
        at.delete();
        b2.b2World_Step(world, dt, SUB_STEPS);
        const events = b2.b2World_GetSensorEvents(world);
        for (let i = 0; i < events.beginCount; i++) {
          const event = events.GetBeginEvent(i);
          const touched = event.visitorShapeId.index1;
          outcome ??= endings.find((e) => e.index === touched)?.ends ?? null;
        }
        events.delete();
      },
      read(out) {
        const at = b2.b2Body_GetPosition(astronaut);
        const velocity = b2.b2Body_GetLinearVelocity(astronaut);
        out[0] = at.x * PX_PER_METRE;
        out[1] = at.y * PX_PER_METRE;
        out[2] = velocity.x * PX_PER_METRE;
        out[3] = velocity.y * PX_PER_METRE;
        at.delete();
        velocity.delete();
      },
      get outcome() {
        return outcome;
      },
      dispose() {
        b2.b2DestroyWorld(world);
      },
    };
  },
};
