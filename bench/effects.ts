import { type AccuracyName, compile, createSimulation, joinHolds, simulate, TICK_RATE } from '../engine/index.ts';
import { type Hold, type LevelFile, resolveLevel } from '../schema/index.ts';
import { ORBIT, ORBIT_FILE } from '../tests/scenes/index.ts';
import { ACCURACY_NAMES, accuracy as accuracyOption, atMost, compare, define } from './harness/index.ts';
import { lasting } from './replayer.ts';

const SECONDS = 60;
const TICKS = SECONDS * TICK_RATE;

/** An effect that reports events counts as acting in a scene with at least this many of them. */
const ENOUGH_EVENTS = 5;

interface Played {
  readonly level: LevelFile;
  readonly holds: readonly Hold[];
}

/** One effect in three scenes: without it, with it where it can never act, and with it acting. */
interface EffectCase {
  readonly effect: string;
  readonly without: Played;
  readonly inert: Played;
  /** Scenes to try in turn; the first one that lasts its minute and in which the effect acted is measured. */
  readonly acting: readonly Played[];
  /** What `acting` is compared with if that is not `without`. */
  readonly actingWithout?: Played;
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

/** She moves without the gun, back and forth between two repulsors. */
const bouncing: LevelFile = {
  ...ORBIT_FILE,
  astronaut: { x: 0, y: 0, vx: 10, vy: 0 },
  repulsors: [
    { x: -60, y: 0, radius: 48 },
    { x: 60, y: 0, radius: 48 },
  ],
};
const asteroids = ORBIT_FILE.asteroids ?? [];
const novae = ORBIT_FILE.novae ?? [];

const CASES: readonly EffectCase[] = [
  {
    effect: 'novae',
    without: held({ ...ORBIT_FILE, novae: [] }),
    inert: orbit,
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
    inert: held({ ...ORBIT_FILE, asteroids: asteroids.map((a, i) => ({ ...a, hot: i > 3 })) }),
    acting: [held({ ...ORBIT_FILE, asteroids: asteroids.map((a, i) => ({ ...a, hot: i === 0 })) })],
    sign: null,
  },
  {
    effect: 'minerals',
    without: orbit,
    inert: held({ ...ORBIT_FILE, minerals: [0, 1, 2].map((i) => ({ x: 700 + 50 * i, y: -700 })) }),
    acting: [held({ ...ORBIT_FILE, minerals: [0, 1, 2].map((i) => ({ x: [100, -90, 0][i], y: [20, 0, 95][i] })) })],
    sign: 'mineral',
  },
  {
    effect: 'repulsor',
    without: orbit,
    inert: held({ ...ORBIT_FILE, repulsors: [{ x: 700, y: -700, radius: 48 }] }),
    acting: ring([150, 140, 130, 120, 110]).map((place) => held({ ...ORBIT_FILE, repulsors: [{ ...place, radius: 48 }] })),
    sign: 'enter',
  },
  {
    effect: 'winds',
    without: orbit,
    inert: held({ ...ORBIT_FILE, winds: [{ x: 700, y: -700, radius: 48, ax: 0, ay: -20 }] }),
    acting: ring([100, 90, 80]).map((place) => held({ ...ORBIT_FILE, winds: [{ ...place, radius: 48, ax: 2, ay: 0 }] })),
    sign: 'winds',
  },
  {
    effect: 'wormholes',
    without: orbit,
    inert: held({ ...ORBIT_FILE, wormholes: [{ x: 700, y: -700, toX: 900, toY: -700, radius: 16 }] }),
    acting: ring([100, 90, 80]).map(({ x, y }) =>
      held({ ...ORBIT_FILE, wormholes: [{ x, y, toX: x - 40, toY: y, radius: 12 }] }),
    ),
    sign: 'wormholes',
  },
  {
    effect: 'alien-chase',
    without: orbit,
    inert: held({ ...ORBIT_FILE, aliens: [{ x: 700, y: -700 }] }),
    acting: ring([258, 255, 252, 249, 246, 243, 240]).map((place) => held({ ...ORBIT_FILE, aliens: [place] })),
    sign: 'wake',
  },
  ...[8, 100, 1000].map(
    (count): EffectCase => ({
      effect: `${count} aliens asleep`,
      without: orbit,
      inert: held({
        ...ORBIT_FILE,
        aliens: Array.from({ length: count }, (_, i) => ({ x: 700 + 60 * (i % 32), y: -700 - 60 * Math.floor(i / 32) })),
      }),
      acting: [],
      sign: null,
    }),
  ),
  {
    effect: 'alien-explosion',
    without: held({ ...ORBIT_FILE, aliens: [{ x: 700, y: -700 }] }),
    inert: held({
      ...ORBIT_FILE,
      aliens: [
        { x: 700, y: -700 },
        { x: 800, y: -800 },
      ],
    }),
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
  {
    effect: 'recoil',
    without: { level: bouncing, holds: [] },
    inert: { level: { ...bouncing, recoil: true }, holds: [] },
    acting: [held({ ...ORBIT_FILE, recoil: true })],
    actingWithout: orbit,
    sign: null,
  },
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
    if (sign === 'wake')
      shown = level.aliens.some((alien, i) => Math.hypot(aliens[3 * i] - alien.x, aliens[3 * i + 1] - alien.y) > 5);
    if (sign === 'explosion') shown = aliens[2] === 0 && aliens[5] === 0;
  }
  return shown && simulation.ending === null;
}

export const bench = define({
  what: 'what each effect costs, acting and idle',
  options: { accuracy: accuracyOption(null) },
  claims: { inert: atMost(1.08, 'present but never able to act / without') },
  run({ accuracy: only }) {
    const rows: (string | number | null)[][] = [];
    const inertRatios: Record<string, number> = {};
    const notes: string[] = [];
    for (const accuracy of ACCURACY_NAMES.filter((name) => only === null || only === name)) {
      for (const { effect, without, inert, acting, actingWithout, sign } of CASES) {
        const found = acting.find((played) => acts(played, accuracy, sign));
        if (found === undefined && acting.length > 0)
          notes.push(`${accuracy}: none of ${acting.length} scenes lasts a minute with ${effect} acting.`);
        const played: readonly (readonly [string, Played | undefined])[] = [
          ['without', without],
          ['inert', inert],
          ['acting without', actingWithout],
          ['acting', found],
        ];
        const scenes = played.flatMap(([name, scene]) => {
          if (scene === undefined) return [];
          const made = { level: resolveLevel(scene.level), holds: scene.holds, seconds: SECONDS };
          return [{ name, ...lasting(made, accuracy, `${accuracy}, ${effect}, ${name}`) }];
        });
        const [plain, idle] = scenes;
        if (plain.state.some((value, i) => !Object.is(value, idle.state[i]))) {
          throw new Error(`${accuracy}: ${effect} that can never act changes where she ends`);
        }
        const measured = compare(scenes, { rounds: 101, sampleMs: 1.5, warmUpMs: 100 });
        const cost = (name: string) => (1000 * measured.time(name).median) / SECONDS;
        const ratio = (name: string, base: string) => measured.ratio(name, base).median;
        const base = actingWithout === undefined ? 'without' : 'acting without';
        rows.push([
          `${accuracy}, ${effect}`,
          ...[cost('without'), cost('inert'), ratio('inert', 'without')],
          ...(found === undefined ? [null, null] : [cost('acting'), ratio('acting', base)]),
        ]);
        // arcade examines everything once per frame, like the original, so idle objects cost it as much as others
        if (accuracy !== 'arcade') inertRatios[`${accuracy}, ${effect}`] = ratio('inert', 'without');
      }
    }
    return {
      title: 'What each effect costs: us a simulated second of a minute around one of 12 circles',
      columns: ['', 'without', 'never acts', 'ratio', 'acting', 'ratio'],
      rows,
      measured: { inert: inertRatios },
      notes: [
        ...notes,
        'Medians of 101 interleaved rounds, ratios pair by pair. recoil never acts where the gun is never fired: she bounces between two repulsors; acting, it is ' +
          'compared with the same swings without recoil. The gun, the range, the black hole and the speed limit are in every level: no cost without them. ' +
          'arcade looks at every object once a frame, as the original does, so nothing is claimed of it.',
      ],
    };
  },
});
