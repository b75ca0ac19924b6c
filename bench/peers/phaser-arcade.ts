import { createRequire } from 'node:module';
import type * as PhaserModule from 'phaser';
import { DEFAULT_BOX } from '../../engine/index.ts';
import { DEFAULT_RULES, type Level } from '../../schema/index.ts';
import { type Peer, type PeerOutcome, type PeerWorld, requireSupported } from './peer.ts';
import { touchables } from './touchables.ts';

type Phaser = typeof PhaserModule;

let phaser: Phaser | null = null;

/** The few browser globals that Phaser reads while its file is evaluated; its physics reads none of them later. */
function browserStubs(): Record<string, unknown> {
  const pixel = { data: new Uint8ClampedArray(4) };
  const context = { fillRect() {}, drawImage() {}, putImageData() {}, getImageData: () => pixel, createImageData: () => pixel };
  const element = () => ({ style: {}, getContext: () => context, canPlayType: () => '' });
  return {
    window: globalThis,
    navigator: { userAgent: 'node' },
    document: { createElement: element, documentElement: {} },
    Image: class {},
    HTMLCanvasElement: class {},
  };
}

/** Evaluates Phaser's own bundle with the stubs in place, then removes them, since other engines check for `window`. */
function evaluatePhaser(): Phaser {
  const stubs = Object.entries(browserStubs());
  const before = stubs.map(([name]) => Object.getOwnPropertyDescriptor(globalThis, name));
  for (const [name, value] of stubs) Object.defineProperty(globalThis, name, { value, configurable: true, writable: true });
  try {
    return createRequire(import.meta.url)('phaser') as Phaser;
  } finally {
    for (const [i, [name]] of stubs.entries()) {
      const was = before[i];
      if (was === undefined) Reflect.deleteProperty(globalThis, name);
      else Object.defineProperty(globalThis, name, was);
    }
  }
}

/** What ArcadePhysics and a Zone need of a scene without a game. */
function headlessScene(Phaser: Phaser): PhaserModule.Scene {
  const sys = {
    events: new Phaser.Events.EventEmitter(),
    settings: { physics: {} },
    game: { config: { physics: {} } },
    scale: { width: 1, height: 1 },
    queueDepthSort() {},
  };
  return { sys } as unknown as PhaserModule.Scene;
}

/** The game's event of that name calls ArcadePhysics.boot; its types leave it out. */
type Booted = PhaserModule.Physics.Arcade.ArcadePhysics & { boot(): void };

/**
 * Phaser's Arcade physics: the real package without a game. It uses the plugin, its world, bodies on Zones (game objects that
 * draw nothing), `closest`, `accelerateToObject`, and overlap colliders against static bodies in the world's own tree. Arcade
 * boxes do not turn: contacts are those of the upright box.
 */
export const phaserArcade: Peer = {
  name: 'Phaser Arcade',
  precision: 'double',

  async load() {
    phaser ??= evaluatePhaser();
  },

  create(level: Level, rate: number): PeerWorld {
    requireSupported(level);
    if (phaser === null) throw new Error('load() first');
    const Phaser = phaser;
    const scene = headlessScene(Phaser);
    const physics = new Phaser.Physics.Arcade.ArcadePhysics(scene) as Booted;
    physics.boot();
    const { world } = physics;
    world.setFPS(rate);
    // there is one moving body: rebuilding the tree of moving bodies in each step, the default, would only cost time
    world.useTree = false;

    const { x, y, vx, vy } = level.astronaut;
    const astronaut = new Phaser.GameObjects.Zone(scene, x, y, 2 * DEFAULT_BOX.halfWidth, 2 * DEFAULT_BOX.halfHeight);
    physics.add.existing(astronaut);
    const body = astronaut.body as PhaserModule.Physics.Arcade.Body;
    body.setVelocity(vx, vy);
    body.setMaxVelocity(DEFAULT_RULES.speedLimit, DEFAULT_RULES.speedLimit);

    const zones = touchables(level).map((circle) => {
      const zone = new Phaser.GameObjects.Zone(scene, circle.x, circle.y, 2 * circle.radius, 2 * circle.radius);
      physics.add.existing(zone, true);
      (zone.body as PhaserModule.Physics.Arcade.StaticBody).setCircle(circle.radius);
      return { circle, zone };
    });
    const ends = new Map<unknown, PeerOutcome>(zones.map(({ circle, zone }) => [zone, circle.ends]));
    const asteroidZones = zones.slice(1 + level.novae.length, 1 + level.novae.length + level.asteroids.length).map((z) => z.zone);
    const coldFirst = [
      ...asteroidZones.filter((_, i) => !level.asteroids[i].hot),
      ...asteroidZones.filter((_, i) => level.asteroids[i].hot),
    ];

    let outcome: PeerOutcome = null;
    const group = new Phaser.Physics.Arcade.StaticGroup(
      world,
      scene,
      zones.map((z) => z.zone),
    );
    world.addOverlap(astronaut, group, (_, touched) => {
      outcome ??= ends.get(touched) ?? null;
    });

    return {
      step(held) {
        const target = physics.closest(astronaut, coldFirst) as PhaserModule.GameObjects.Zone | null;
        if (target !== null) {
          const distance = Phaser.Math.Distance.BetweenPoints(astronaut, target);
          if (distance > level.range) outcome ??= 'lost';
          if (held)
            astronaut.rotation = physics.accelerateToObject(astronaut, target, DEFAULT_RULES.pull * (1 - distance / level.range));
          else body.setAcceleration(0, 0);
        }
        world.singleStep();
      },
      read(out) {
        out[0] = astronaut.x;
        out[1] = astronaut.y;
        out[2] = body.velocity.x;
        out[3] = body.velocity.y;
      },
      get outcome() {
        return outcome;
      },
      dispose() {
        physics.shutdown();
      },
    };
  },
};
