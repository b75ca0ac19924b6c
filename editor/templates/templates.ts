import { LEVEL_VERSION, type LevelFile, type Place, withIds } from '../../schema/index.ts';
import { createRandom } from '../../solver/index.ts';

/** A level to begin with. */
export interface Template {
  readonly id: 'empty' | 'first-swing' | 'random';
  readonly title: string;
  /** One line. */
  readonly about: string;
  /** Whether another seed gives another level. */
  readonly usesSeed: boolean;
  /** @param seed a whole number; the same one gives the same level */
  readonly make: (name: string, seed: number) => LevelFile;
}

/** What a new level shows, px. */
const WIDTH = 1280;
const HEIGHT = 720;
/** So far from the edges things are thrown, px. */
const BORDER = 100;
/** Between thrown things, and between them and the astronaut or the black hole, px: a box and a nova that don't touch. */
const APART = 64;
/** In the middle she must be in reach of an asteroid: nearer than this, px. */
const NEAR = 230;

const empty = (name: string): LevelFile => ({
  version: LEVEL_VERSION,
  name,
  astronaut: { x: 320, y: 360 },
  blackHole: { x: 640, y: 360 },
  asteroids: [{ x: 480, y: 360, radius: 16 }],
});

const firstSwing = (name: string): LevelFile => ({
  version: LEVEL_VERSION,
  name,
  description: 'She passes an asteroid: hold, and it bends her way into an arc; let go, and she flies on.',
  astronaut: { x: 400, y: 560, vx: 0, vy: -60 },
  blackHole: { x: 730, y: 310 },
  asteroids: [{ x: 500, y: 420, radius: 32 }],
  runs: [{ name: 'solution', holds: [[150, 435]] }],
});

/** The demo that the game began with: seven asteroids and three novae thrown anywhere, the astronaut in the middle. */
function thrown(name: string, seed: number): LevelFile {
  const random = createRandom(seed);
  const places: Place[] = [{ x: WIDTH / 2, y: HEIGHT / 2 }];
  const farEnough = (a: Place) => places.every((b) => (a.x - b.x) ** 2 + (a.y - b.y) ** 2 >= APART ** 2);
  const between = (least: number, most: number) => Math.round(least + random.unit() * (most - least));
  const throwOne = (): Place => {
    for (;;) {
      const place = { x: between(BORDER, WIDTH - BORDER), y: between(BORDER, HEIGHT - BORDER) };
      if (!farEnough(place)) continue;
      places.push(place);
      return place;
    }
  };
  const near = ({ x, y }: Place) => (x - WIDTH / 2) ** 2 + (y - HEIGHT / 2) ** 2 <= NEAR ** 2;
  const first = (): Place => {
    for (;;) {
      const place = throwOne();
      if (near(place)) return place;
      places.pop();
    }
  };
  const asteroids = [first(), ...Array.from({ length: 6 }, throwOne)].map((place) => ({
    ...place,
    radius: random.below(2) === 0 ? 16 : 32,
  }));
  const novae = Array.from({ length: 3 }, throwOne).map((place) => ({ ...place, radius: 16 }));
  return {
    version: LEVEL_VERSION,
    name,
    description: `Thrown by chance, seed ${seed}.`,
    astronaut: places[0],
    blackHole: throwOne(),
    range: 2 * WIDTH,
    asteroids,
    novae,
  };
}

/** What a new level can begin with. */
export const TEMPLATES: readonly Template[] = [
  {
    id: 'empty',
    title: 'Empty',
    about: 'One asteroid, the astronaut and the black hole.',
    usesSeed: false,
    make: (name) => withIds(empty(name)),
  },
  {
    id: 'first-swing',
    title: 'A first swing',
    about: 'One press around one asteroid, with a run that completes it.',
    usesSeed: false,
    make: (name) => withIds(firstSwing(name)),
  },
  {
    id: 'random',
    title: 'Thrown by chance',
    about: 'Seven asteroids and three novae anywhere, the astronaut in the middle: fly, crash, begin again.',
    usesSeed: true,
    make: (name, seed) => withIds(thrown(name, seed)),
  },
];
