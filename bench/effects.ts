import { type AccuracyName, compile, createSimulation, joinHolds, simulate, TICK_RATE } from '../engine/index.ts';
import { type Hold, type LevelFile, type ObjectList, resolveLevel } from '../schema/index.ts';
import { ORBIT, ORBIT_FILE, seeded, TWELVE_CIRCLES } from '../tests/scenes/index.ts';
import { ACCURACY_NAMES, accuracy as accuracyOption, atMost, compare, define, figure } from './harness/index.ts';
import { lasting } from './replayer.ts';

const SECONDS = 60;
const TICKS = SECONDS * TICK_RATE;

/** An effect that reports events counts as acting in a scene with at least this many of them. */
const ENOUGH_EVENTS = 5;

interface Played {
  readonly level: LevelFile;
  readonly holds: readonly Hold[];
}

/** One effect in two scenes: without it, and with it acting. */
interface EffectCase {
  readonly effect: string;
  readonly without: Played;
  /** Scenes to try in turn; the first one that lasts its minute and in which the effect acted is measured. */
  readonly acting: readonly Played[];
  /** The events, or the outcome, that show that the effect acted; null if its presence is enough. */
  readonly sign: 'wake' | 'enter' | 'explosion' | 'mineral' | 'winds' | 'wormholes' | null;
}

const held = (level: LevelFile): Played => ({ level, holds: ORBIT.holds });
const orbit = held(ORBIT_FILE);

/** Places on rings around her orbit, from outside inwards. */
function ring(radii: readonly number[]): { x: number; y: number }[] {
  const around = Array.from({ length: 24 }, (_, i) => (i * Math.PI) / 12);
  return radii.flatMap((r) => around.map((a) => ({ x: Math.round(r * Math.cos(a)), y: Math.round(r * Math.sin(a)) })));
}

const asteroids = ORBIT_FILE.asteroids ?? [];
const novae = ORBIT_FILE.novae ?? [];

const CASES: readonly EffectCase[] = [
  {
    effect: 'novae',
    without: held({ ...ORBIT_FILE, novae: [] }),
    acting: [150, 165, 180, 195, 210].map((far) =>
      held({
        ...ORBIT_FILE,
        novae: novae.map((nova, i) => ({ ...nova, x: far * [1, 0, -1, 0][i], y: far * [0, 1, 0, -1][i], radius: 16 })),
      }),
    ),
    sign: null,
  },
  {
    effect: 'hot-asteroids',
    without: orbit,
    acting: [held({ ...ORBIT_FILE, asteroids: asteroids.map((a, i) => ({ ...a, hot: i === 0 })) })],
    sign: null,
  },
  {
    effect: 'minerals',
    without: orbit,
    acting: [held({ ...ORBIT_FILE, minerals: [0, 1, 2].map((i) => ({ x: [100, -90, 0][i], y: [20, 0, 95][i] })) })],
    sign: 'mineral',
  },
  {
    effect: 'repulsor',
    without: orbit,
    acting: ring([150, 140, 130, 120, 110]).map((place) => held({ ...ORBIT_FILE, repulsors: [{ ...place, radius: 48 }] })),
    sign: 'enter',
  },
  {
    effect: 'winds',
    without: orbit,
    acting: ring([100, 90, 80]).map((place) => held({ ...ORBIT_FILE, winds: [{ ...place, radius: 48, ax: 2, ay: 0 }] })),
    sign: 'winds',
  },
  {
    effect: 'wormholes',
    without: orbit,
    acting: ring([100, 90, 80]).map(({ x, y }) =>
      held({ ...ORBIT_FILE, wormholes: [{ x, y, toX: x - 40, toY: y, radius: 12 }] }),
    ),
    sign: 'wormholes',
  },
  {
    effect: 'alien-chase',
    without: orbit,
    acting: ring([258, 255, 252, 249, 246, 243, 240]).map((place) => held({ ...ORBIT_FILE, aliens: [place] })),
    sign: 'wake',
  },
  {
    effect: 'alien-explosion',
    without: held({ ...ORBIT_FILE, aliens: [{ x: 700, y: -700 }] }),
    acting: ring([235, 230, 225, 220, 210, 200]).map(({ x, y }) =>
      held({
        ...ORBIT_FILE,
        aliens: [
          { x: x - 0.13 * y, y: y + 0.13 * x },
          { x: x + 0.13 * y, y: y - 0.13 * x },
        ],
      }),
    ),
    sign: 'explosion',
  },
  { effect: 'recoil', without: orbit, acting: [held({ ...ORBIT_FILE, recoil: true })], sign: null },
];

/** Plays a scene; returns whether its effect acted and she is still alive at the end. */
function acts(played: Played, accuracy: AccuracyName, sign: EffectCase['sign']): boolean {
  if (sign !== 'winds' && sign !== 'wormholes') return showsTickByTick(played, accuracy, sign);
  const { events, outcome } = simulate(compile(resolveLevel(played.level), accuracy), played.holds, { maxTime: SECONDS });
  const own = events.filter((event) => event.type === 'effect' && event.effect === sign);
  return outcome === 'timeout' && own.length >= ENOUGH_EVENTS;
}

function showsTickByTick(played: Played, accuracy: AccuracyName, sign: EffectCase['sign']): boolean {
  const simulation = createSimulation(compile(resolveLevel(played.level), accuracy));
  const { level } = simulation.scene;
  const aliens = new Float64Array(3 * level.aliens.length);
  const state = new Float64Array(6);
  let shown = sign === null;
  const script = joinHolds(played.holds);
  for (let tick = 0; tick < TICKS && simulation.ending === null; tick++) {
    simulation.advance(
      1,
      script.some(([press, release]) => press <= tick && tick < release),
    );
    if (shown) continue;
    simulation.readState(state);
    simulation.readAliens(aliens);
    if (sign === 'mineral') shown = simulation.mineralCount === level.minerals.length;
    if (sign === 'enter') shown = level.repulsors.some((r) => Math.hypot(r.x - state[0], r.y - state[1]) < r.radius - 8);
    if (sign === 'wake') shown = level.aliens.some(({ x, y }, i) => Math.hypot(aliens[3 * i] - x, aliens[3 * i + 1] - y) > 5);
    if (sign === 'explosion') shown = aliens[2] === 0 && aliens[5] === 0;
  }
  return shown && simulation.ending === null;
}

/** How many idle objects there are, and what a run with them may cost, over one without. */
const MOST_IDLE = { 8: 1.05, 100: 1.1, 1000: 1.2 } as const;

/** Places all over the plane, far from each other and 2,000 px from the middle of the 12 circles: she stays within 500 px of it. */
function scattered(count: number): { x: number; y: number }[] {
  const random = seeded(count);
  const side = 4500 + 250 * Math.sqrt(count);
  const places: { x: number; y: number }[] = [];
  while (places.length < count) {
    const place = { x: 400 + side * (random() - 0.5), y: 300 + side * (random() - 0.5) };
    const isAlone = places.every((other) => Math.hypot(place.x - other.x, place.y - other.y) > 100);
    if (isAlone && Math.hypot(place.x - 400, place.y - 300) > 2000) places.push(place);
  }
  return places;
}

/** Idle objects: their list, and one of them. */
const IDLE: Readonly<Record<string, readonly [ObjectList, (at: { x: number; y: number }) => object]>> = {
  novae: ['novae', (at) => ({ ...at, radius: 16 })],
  'hot asteroids': ['asteroids', (at) => ({ ...at, radius: 16, hot: true })],
  'cold asteroids': ['asteroids', (at) => ({ ...at, radius: 16, hot: false })],
  minerals: ['minerals', (at) => ({ ...at, radius: 7 })],
  repulsors: ['repulsors', (at) => ({ ...at, radius: 48 })],
  winds: ['winds', (at) => ({ ...at, radius: 48, ax: 0, ay: -20 })],
  wormholes: ['wormholes', (at) => ({ ...at, toX: at.x + 60, toY: at.y, radius: 16 })],
  'aliens asleep': ['aliens', (at) => ({ ...at, radius: 25 })],
};

/**
 * What idle objects cost: the ratio to a run without them, and that of a second copy without them.
 * @throws {Error} if they change where she ends
 */
function idle(accuracy: AccuracyName, kind: string, count: keyof typeof MOST_IDLE): { ratio: number; control: number } {
  const { level } = TWELVE_CIRCLES;
  const [list, make] = IDLE[kind];
  const objects = scattered(count).map((at) => ({ id: null, ...make(at) }));
  const levels = { without: level, idle: { ...level, [list]: [...level[list], ...objects] }, again: { ...level } };
  const scenes = Object.entries(levels).map(([name, level]) => {
    return { name, ...lasting({ ...TWELVE_CIRCLES, level }, accuracy, `${accuracy}, ${count} ${kind}, ${name}`) };
  });
  const [plain, more] = scenes;
  const isSame = plain.state.every((value, i) => Object.is(value, more.state[i]));
  if (!isSame) throw new Error(`${accuracy}: ${count} ${kind} that can never act change where she ends`);
  const measured = compare(scenes, { rounds: 201, sampleMs: 0.7, warmUpMs: 50 });
  return { ratio: measured.ratio('idle', 'without').median, control: measured.ratio('again', 'without').median };
}

/** What an effect costs as it acts, us a simulated second, and over a run without it; null if it acts in none of the scenes. */
function acting({ effect, without, acting, sign }: EffectCase, accuracy: AccuracyName): [number, number] | null {
  const found = acting.find((played) => acts(played, accuracy, sign));
  if (found === undefined) return null;
  const scenes = Object.entries({ without, acting: found }).map(([name, { level, holds }]) => ({
    name,
    ...lasting({ level: resolveLevel(level), holds, seconds: SECONDS }, accuracy, `${accuracy}, ${effect}, ${name}`),
  }));
  const measured = compare(scenes, { rounds: 101, sampleMs: 1.5, warmUpMs: 50 });
  return [(1000 * measured.time('acting').median) / SECONDS, measured.ratio('acting', 'without').median];
}

export const bench = define({
  what: 'what each effect costs, acting and idle',
  options: { accuracy: accuracyOption(null) },
  claims: {
    idle8: atMost(MOST_IDLE[8], '8 idle objects / none'),
    idle100: atMost(MOST_IDLE[100], '100 idle objects / none'),
    idle1000: atMost(MOST_IDLE[1000], '1,000 idle objects / none'),
  },
  run({ accuracy: only }) {
    const rows: (string | number | null)[][] = [];
    const ratios = { idle8: {}, idle100: {}, idle1000: {} } as Record<'idle8' | 'idle100' | 'idle1000', Record<string, number>>;
    const controls: number[] = [];
    for (const accuracy of ACCURACY_NAMES.filter((name) => only === null || only === name)) {
      // arcade examines everything once per frame, like the original, so idle objects cost it as much as others
      for (const kind of accuracy === 'arcade' ? [] : Object.keys(IDLE)) {
        const counts = ([8, 100, 1000] as const).map((count) => {
          const { ratio, control } = idle(accuracy, kind, count);
          ratios[`idle${count}`][`${accuracy}, ${kind}`] = ratio;
          controls.push(control);
          return ratio;
        });
        rows.push([`${accuracy}, ${kind}`, ...counts, null, null]);
      }
      for (const one of CASES)
        rows.push([`${accuracy}, ${one.effect}`, null, null, null, ...(acting(one, accuracy) ?? [null, null])]);
    }
    return {
      title: 'What each effect costs: a minute with idle objects, over one without; and acting, us a simulated second',
      columns: ['', '8 idle', '100 idle', '1,000 idle', 'acting', 'over without'],
      rows,
      measured: ratios,
      notes: [
        `Idle: the scene of 12 circles, whose 42 holds take a minute, with objects all over the plane and at least 1,500 px from her. ` +
          `Medians of 201 interleaved rounds, ratios pair by pair; a second copy without them costs ${controls.length > 0 ? `${figure(Math.min(...controls))} to ${figure(Math.max(...controls))}` : 'as much'}.`,
        'Acting: a minute around one of 12 circles, 101 rounds. The gun, the range, the black hole and the speed limit are in every level: no cost without them. ' +
          'arcade looks at every object once a frame, as the original does, so nothing is claimed of it.',
      ],
    };
  },
});
