import { cpus, totalmem } from 'node:os';

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

export interface Spread {
  readonly median: number;
  readonly q1: number;
  readonly q3: number;
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

/** A claim and whether it was met. */
export interface Claim {
  readonly what: string;
  /** `at most` when left out. */
  readonly bound?: 'at most' | 'at least';
  readonly limit: number;
  readonly measured: number;
  readonly met: boolean;
}

export interface Report {
  readonly title: string;
  readonly columns: readonly string[];
  readonly rows: readonly (readonly (string | number | null)[])[];
  readonly claims: readonly Claim[];
  readonly notes: readonly string[];
}

// results of contestants end up here and are printed, so that no compiler can drop the work
let sink = 0;

/** Keeps a result alive. */
export function consume(value: number): void {
  sink = (sink + value) % 1e9;
}

/** Quartiles by linear interpolation between the closest ranks. */
export function spread(values: readonly number[]): Spread {
  const sorted = [...values].sort((a, b) => a - b);
  const at = (p: number) => {
    const place = p * (sorted.length - 1);
    const low = Math.floor(place);
    const high = Math.min(low + 1, sorted.length - 1);
    return sorted[low] + (place - low) * (sorted[high] - sorted[low]);
  };
  return { median: at(0.5), q1: at(0.25), q3: at(0.75) };
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

export const atMost = (what: string, measured: number, limit: number): Claim => ({
  what,
  bound: 'at most',
  limit,
  measured,
  met: measured <= limit,
});

export const atLeast = (what: string, measured: number, limit: number): Claim => ({
  what,
  bound: 'at least',
  limit,
  measured,
  met: measured >= limit,
});

/** The machine and the runtime that the figures come from. */
export function machine(): { cpu: string; cores: number; memory: string; node: string; v8: string; platform: string } {
  const all = cpus();
  return {
    cpu: all[0]?.model.trim() ?? 'unknown',
    cores: all.length,
    memory: `${Math.round(totalmem() / 2 ** 30)} GiB`,
    node: process.version,
    v8: process.versions.v8,
    platform: `${process.platform} ${process.arch}`,
  };
}

/** Four significant digits, without an exponent where it is readable without. */
export function figure(value: number): string {
  if (value === 0 || !Number.isFinite(value)) return String(value);
  const size = Math.abs(value);
  if (size < 1e-3 || size >= 1e6) return value.toExponential(2);
  return String(Number(value.toPrecision(4)));
}

/** The argument after `option` on the command line; null if the option is not given. */
export function optionValue(option: string): string | null {
  const place = process.argv.indexOf(option);
  return place < 0 ? null : (process.argv[place + 1] ?? null);
}

/** Prints a report as a table, or as JSON with --json. Sets the exit code to 1 if a claim was not met. */
export function publish(report: Report): void {
  if (report.claims.some((claim) => !claim.met)) process.exitCode = 1;
  if (process.argv.includes('--json')) {
    console.log(JSON.stringify({ ...report, machine: machine(), sink }, null, 2));
    return;
  }
  const m = machine();
  console.log(`${report.title}\n${m.cpu}, ${m.cores} cores, ${m.memory}, ${m.platform}, Node ${m.node} (V8 ${m.v8})\n`);
  const cells = report.rows.map((row) => row.map((cell) => (typeof cell === 'number' ? figure(cell) : (cell ?? '-'))));
  const widths = report.columns.map((column, i) => Math.max(column.length, ...cells.map((row) => row[i].length)));
  const line = (row: readonly string[]) =>
    row
      .map((cell, i) => (i === 0 ? cell.padEnd(widths[i]) : cell.padStart(widths[i])))
      .join('  ')
      .trimEnd();
  console.log(line(report.columns));
  console.log(widths.map((width) => '-'.repeat(width)).join('  '));
  for (const row of cells) console.log(line(row));
  if (report.claims.length > 0) console.log('');
  for (const claim of report.claims) {
    console.log(
      `${claim.met ? 'met    ' : 'NOT MET'}  ${claim.what}: ${figure(claim.measured)} (${claim.bound ?? 'at most'} ${figure(claim.limit)})`,
    );
  }
  for (const note of report.notes) console.log(`\n${note}`);
}
