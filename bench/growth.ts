import { type AccuracyName, compile, createSimulation, joinHolds, playScript, unlimited } from '../engine/index.ts';
import { type LevelFile, resolveLevel } from '../schema/index.ts';
import { atMost, define, figure, mean, processorTime, sum, text } from './harness/index.ts';

/**
 * Time may grow like n log n. Between some hundred and some thousand objects that is an exponent of about 1.1, and clocks are
 * inexact.
 */
const STEEPEST = 1.15;

const SIZES = [1250, 2500, 5000, 10_000, 20_000];
const TICKS = 20 * 60;

type Place = { readonly x: number; readonly y: number };

const many = <T>(count: number, make: (i: number) => T): T[] => Array.from({ length: count }, (_, i) => make(i));

/** Places on a square grid, with the start in a gap of it. The number of places near her does not depend on `count`. */
function grid(count: number, step: number): Place[] {
  const side = Math.ceil(Math.sqrt(count + 16));
  return many(side * side, (i) => ({ x: (i % side) - side / 2 + 0.5, y: Math.floor(i / side) - side / 2 + 0.5 }))
    .filter(({ x, y }) => Math.abs(x) > 2 || Math.abs(y) > 2)
    .slice(0, count)
    .map(({ x, y }) => ({ x: x * step, y: y * step }));
}

/** She swings about an asteroid in the middle. */
const SWING: LevelFile = {
  version: 1,
  name: 'Growth',
  astronaut: { x: 0, y: 0, vx: 0, vy: 40 },
  blackHole: { x: 0, y: 1e6 },
  range: 250,
  asteroids: [{ x: 100, y: 0, radius: 16 }],
};

const taps = (count: number, every: number): [number, number][] =>
  many(count, (i): [number, number] => [every * i, every * i + Math.ceil(every / 2)]);

/** A level with `n` objects of one kind, and how it is played. A level's runs are played one after the other. */
const KINDS: Readonly<Record<string, (n: number) => LevelFile>> = {
  'cold asteroids': (n) => ({
    ...SWING,
    asteroids: [...(SWING.asteroids ?? []), ...grid(n, 200).map((p) => ({ ...p, radius: 16 }))],
    runs: [{ name: 'a', holds: [[0, TICKS]] }],
  }),
  'hot asteroids': (n) => ({
    ...SWING,
    asteroids: [...(SWING.asteroids ?? []), ...grid(n, 200).map((p) => ({ ...p, radius: 16, hot: true }))],
    runs: [{ name: 'a', holds: [[0, TICKS]] }],
  }),
  'cold asteroids, recoil': (n) => ({
    ...SWING,
    recoil: true,
    asteroids: [...(SWING.asteroids ?? []), ...grid(n, 200).map((p) => ({ ...p, radius: 16 }))],
    runs: [{ name: 'a', holds: taps(60, 20) }],
  }),
  'hot asteroids, recoil': (n) => ({
    ...SWING,
    recoil: true,
    asteroids: [...(SWING.asteroids ?? []), ...grid(n, 200).map((p) => ({ ...p, radius: 16, hot: true }))],
    runs: [{ name: 'a', holds: taps(60, 20) }],
  }),
  novae: (n) => ({
    ...SWING,
    novae: grid(n, 150).map((p) => ({ ...p, radius: 16 })),
    runs: [{ name: 'a', holds: [[0, TICKS]] }],
  }),
  minerals: (n) => ({ ...SWING, minerals: grid(n, 40), runs: [{ name: 'a', holds: [[0, TICKS]] }] }),
  repulsors: (n) => ({
    ...SWING,
    repulsors: grid(n, 150).map((p) => ({ ...p, radius: 48 })),
    runs: [{ name: 'a', holds: [[0, TICKS]] }],
  }),
  'aliens asleep': (n) => ({ ...SWING, aliens: grid(n, 200), runs: [{ name: 'a', holds: [[0, TICKS]] }] }),
  'aliens woken one by one': (n) => ({
    ...SWING,
    astronaut: { x: 0, y: 0, vx: 1000, vy: 0 },
    range: 1e6,
    // she passes all of them in the time, whatever their number
    aliens: many(n, (i) => ({ x: 400 + (20_000 * i) / n, y: i % 2 === 0 ? 120 : -120, radius: 0.01 })),
    runs: [{ name: 'a', holds: [] }],
  }),
  runs: (n) => ({ ...SWING, runs: many(n / 20, (i) => ({ name: `${i}`, holds: [[i % 60, TICKS]] })) }),
  holds: (n) => ({ ...SWING, runs: many(Math.ceil(n / 600), (i) => ({ name: `${i}`, holds: taps(600, 2) })) }),
};

/** Slope of a straight line through the logarithms. */
function exponent(sizes: readonly number[], values: readonly number[]): number {
  const x = sizes.map(Math.log);
  const y = values.map(Math.log);
  const [mx, my] = [mean(x), mean(y)];
  const rise = sum(x.map((a, i) => (a - mx) * (y[i] - my)));
  return rise / sum(x.map((a) => (a - mx) * (a - mx)));
}

/** Plays a level's runs at an accuracy: the least ms of several repetitions, since disturbances only ever make it longer, and its work. */
function measure(file: LevelFile, accuracy: AccuracyName): { time: number; work: number } {
  const level = resolveLevel(file);
  let work = 0;
  const times = many(5, () =>
    processorTime(() => {
      const budget = unlimited();
      const simulation = createSimulation(compile(level, accuracy), budget);
      for (const { holds } of level.runs) {
        simulation.reset();
        playScript(simulation, joinHolds(holds), TICKS);
      }
      work = budget.looks;
    }),
  );
  return { time: Math.min(...times), work };
}

export const bench = define({
  what: 'how the time of a run grows with the number of objects of each kind',
  options: { only: text('kinds whose names contain this') },
  claims: { exponent: atMost(STEEPEST, 'exponent of the time') },
  run({ only }) {
    const exponents: Record<string, number> = {};
    const kinds = Object.entries(KINDS).filter(([kind]) => only === null || kind.includes(only));
    const rows = kinds.flatMap(([kind, make]) =>
      (['precise', 'fast', 'arcade'] as const).map((accuracy) => {
        const found = SIZES.map((n) => measure(make(n), accuracy));
        const times = found.map(({ time }) => time);
        const name = `${kind}, ${accuracy}`;
        exponents[name] = exponent(SIZES, times);
        const ofWork = exponent(
          SIZES,
          found.map(({ work }) => work),
        );
        return [name, ...times, exponents[name], ofWork];
      }),
    );
    return {
      title: 'How the time of a run grows with the number of one kind of thing: ms, compiled and played for 20 s',
      columns: ['', ...SIZES.map((n) => figure(n)), 'exponent', 'of the work'],
      rows,
      measured: { exponent: exponents },
      notes: [
        'Processor time, least of 5. n log n is an exponent of about 1.1 here. "of the work" is that of the work counted for --max-work. runs: a twentieth of n; ' +
          'holds: of 600 a run. Aliens that are awake at the same time all follow her, and each that wakes or sleeps begins a new piece for all of them.',
      ],
    };
  },
});
