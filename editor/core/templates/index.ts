import { LEVEL_VERSION, type LevelFile, type Place, withIds } from '../../../schema/index.ts';
import { createRandom } from '../../../solver/index.ts';

/** A template for a new level. */
export interface Template {
  readonly id: 'empty' | 'first-swing' | 'random';
  readonly title: string;
  /** one line */
  readonly about: string;
  /** whether another seed gives another level */
  readonly usesSeed: boolean;
  /** @param seed a whole number; the same seed gives the same level */
  readonly make: (name: string, seed: number) => LevelFile;
}

/** size of the picture of a new level, px */
const WIDTH = 1280;
const HEIGHT = 720;
/** least distance of random objects from the edges, px */
const BORDER = 100;
/**
 * least distance between random objects, and from them to the astronaut and the black hole, px: enough that a collision box and
 * a nova don't touch
 */
const APART = 64;
/** At least one asteroid lies within this distance of the astronaut, px. */
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
  description: 'She passes an asteroid: hold the gun to bend her path into an arc, release it to fly on.',
  astronaut: { x: 400, y: 560, vx: 0, vy: -60 },
  blackHole: { x: 730, y: 310 },
  asteroids: [{ x: 500, y: 420, radius: 32 }],
  runs: [{ name: 'solution', holds: [[150, 435]] }],
});

/** The random level that the game began with: seven asteroids and three novae anywhere, the astronaut in the middle. */
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
    description: `Random level, seed ${seed}.`,
    astronaut: places[0],
    blackHole: throwOne(),
    range: 2 * WIDTH,
    asteroids,
    novae,
  };
}

/** The templates that a new level can begin with. */
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
    about: 'One asteroid and one hold, with a run that completes the level.',
    usesSeed: false,
    make: (name) => withIds(firstSwing(name)),
  },
  {
    id: 'random',
    title: 'Random',
    about: 'Seven asteroids and three novae at random places, the astronaut in the middle.',
    usesSeed: true,
    make: (name, seed) => withIds(thrown(name, seed)),
  },
];
