import { consume } from './report.ts';
import { type Spread, spread } from './statistics.ts';

/** One contestant: `run` does the work once and returns a number that depends on all of it. */
export interface Contestant {
  readonly name: string;
  run(): number;
  /** Called before each `run`; not timed. */
  prepare?(): void;
}

export interface CompareOptions {
  /** Number of rounds; every contestant is timed once in each. */
  readonly rounds?: number;
  /** Shortest time of one sample, ms: a contestant repeats its work until a sample takes about this long. */
  readonly sampleMs?: number;
  /** How long each contestant warms up, ms. */
  readonly warmUpMs?: number;
}

/** Times of every contestant, measured side by side. `samples[name][round]` is the time of one `run`, ms. */
export interface Comparison {
  readonly rounds: number;
  readonly samples: Readonly<Record<string, readonly number[]>>;
  /** Time of one run, ms. */
  time(name: string): Spread;
  /** Time of `a` divided by time of `b`, taken within each round, so that a disturbance of the machine affects both. */
  ratio(a: string, b: string): Spread;
  /** Time of `a` minus time of `b`, ms, likewise. */
  difference(a: string, b: string): Spread;
}

/** Mean time of `times` runs, ms. */
function timed(contestant: Contestant, times: number): number {
  if (contestant.prepare === undefined) {
    const start = performance.now();
    for (let i = 0; i < times; i++) consume(contestant.run());
    return (performance.now() - start) / times;
  }
  let spent = 0;
  for (let i = 0; i < times; i++) {
    contestant.prepare();
    const start = performance.now();
    consume(contestant.run());
    spent += performance.now() - start;
  }
  return spent / times;
}

/**
 * Times contestants against each other in one process: A B C, B C A, C A B, ... So drift, other load and the garbage of the
 * previous contestant affect all of them alike.
 * @throws {RangeError} for fewer than two contestants or 15 rounds: such a ratio means little
 */
export function compare(contestants: readonly Contestant[], options: CompareOptions = {}): Comparison {
  const { rounds = 31, sampleMs = 5, warmUpMs = 300 } = options;
  if (contestants.length < 2) throw new RangeError(`expected at least two contestants, found ${contestants.length}`);
  if (rounds < 15) throw new RangeError(`expected at least 15 rounds, found ${rounds}`);

  for (const contestant of contestants) warmUp(contestant, warmUpMs);
  // determined after all have warmed up, when the code that they share is optimised for all of them
  const times = contestants.map((contestant) => timesToLast(contestant, sampleMs));
  const samples: Record<string, number[]> = Object.fromEntries(contestants.map((c) => [c.name, []]));
  for (let round = 0; round < rounds; round++) {
    for (let k = 0; k < contestants.length; k++) {
      const i = (round + k) % contestants.length;
      samples[contestants[i].name].push(timed(contestants[i], times[i]));
    }
  }
  return {
    rounds,
    samples,
    time: (name) => spread(samples[name]),
    ratio: (a, b) => spread(samples[a].map((t, i) => t / samples[b][i])),
    difference: (a, b) => spread(samples[a].map((t, i) => t - samples[b][i])),
  };
}

/** Runs a contestant for about `ms`, at least once. */
function warmUp(contestant: Contestant, ms: number): void {
  const until = performance.now() + ms;
  do timed(contestant, 1);
  while (performance.now() < until);
}

/**
 * How often a contestant must run to take about `ms`. Found by doubling, since one short run mostly measures the clock's error.
 */
function timesToLast(contestant: Contestant, ms: number): number {
  for (let times = 1; ; times *= 2) {
    // the fastest of several: one that was interrupted would lead to fewer repetitions, and run colder than the others
    const spent = times * Math.min(...Array.from({ length: 5 }, () => timed(contestant, times)));
    if (spent >= ms / 4) return Math.max(1, Math.round((times * ms) / Math.max(spent, 1e-6)));
  }
}

/** Cells of a row: the name of a contestant, the median of its times and the quartiles, in units of so many ms. */
export function timeCells(measured: Comparison, name: string, digits = 1, unit = 1): [string, number, string] {
  const { median, q1, q3 } = measured.time(name);
  return [name, median / unit, `${(q1 / unit).toFixed(digits)} - ${(q3 / unit).toFixed(digits)}`];
}
