import { isMainThread, parentPort, Worker, workerData } from 'node:worker_threads';
import { type AccuracyName, compile, DEFAULT_ACCURACY, isAccuracyName, simulate } from '../engine/index.ts';
import { type Level, resolveLevel } from '../schema/index.ts';
import { createSearch, proveImpossible, verifyProof } from '../solver/index.ts';
import { type Claim, optionValue, publish } from './harness.ts';
import { hashRandomSet, layoutOf, RANDOM_SET_HASH, RANDOM_SET_SIZE, randomLevel } from './random-set/index.ts';

/** What was found out about one level. */
interface Decision {
  readonly seed: number;
  readonly verdict: 'completable' | 'impossible' | 'undecided';
  /** The code of the proof, or what went wrong with it. */
  readonly proof: string | null;
  /** Ticks searched. */
  readonly ticks: number;
  /** Closest approach, px; null when nothing was searched. */
  readonly closest: number | null;
  /** Squares of 32 px that the search reached. */
  readonly squares: number;
  /** Clock time of the search, ms. */
  readonly searchMs: number;
  readonly proofMs: number;
}

interface Task {
  readonly seeds: readonly number[];
  readonly accuracy: AccuracyName;
  /** Ticks of one search of a level that no proof settles. */
  readonly budget: number;
  /** Number of searches, each with its own seed, if the first one gets far. */
  readonly searches: number;
  /** Time to search a level that is proved impossible, ms; 0 for no search. */
  readonly refuteMs: number;
}

// ticks between two readings of the clock
const SLICE = 50_000;

/**
 * A search that reaches no more squares than this ends quickly whatever it presses, so another search would tell nothing new.
 */
const FEW_SQUARES = 40;

const levelOf = (seed: number): Level => resolveLevel(randomLevel(seed));

function decide(seed: number, { accuracy, budget, searches, refuteMs }: Task): Decision {
  const level = levelOf(seed);
  const began = performance.now();
  const proof = proveImpossible(level, { accuracy });
  const proofMs = performance.now() - began;
  const verification = proof === null ? null : verifyProof(level, proof);
  const from = performance.now();
  const scene = compile(level, accuracy);
  let search = createSearch(scene, { seed: 0 });
  let ticks = 0;
  for (let one = 0; one < (proof === null ? searches : 1); one++) {
    if (one > 0) search = createSearch(scene, { seed: one });
    const isOn = (): boolean =>
      proof === null ? search.effort.ticks < budget : refuteMs > 0 && performance.now() - from < refuteMs;
    // a search may run out of work: it is not continued once it no longer advances
    for (let before = -1; search.solutions.length === 0 && search.effort.ticks > before && isOn(); ) {
      before = search.effort.ticks;
      search.advance(Math.min(SLICE, proof === null ? budget - before : SLICE));
    }
    ticks += search.effort.ticks;
    if (search.solutions.length > 0 || search.explored.cells.length <= FEW_SQUARES) break;
  }
  const found = search.solutions.length > 0;
  const wrong =
    verification !== null && !verification.ok ? `unverified: ${verification.why}` : found && proof !== null ? 'REFUTED' : null;
  return {
    seed,
    verdict: found ? 'completable' : proof !== null && wrong === null ? 'impossible' : 'undecided',
    proof: wrong ?? proof?.code ?? null,
    ticks,
    closest: search.closest?.distance ?? null,
    squares: search.explored.cells.length,
    searchMs: performance.now() - from,
    proofMs,
  };
}

function work(task: Task): void {
  for (const seed of task.seeds) parentPort?.postMessage(decide(seed, task));
  parentPort?.postMessage(null);
}

/** Divides the seeds among workers. */
async function decideAll(task: Task, jobs: number): Promise<Decision[]> {
  const decisions: Decision[] = [];
  const share = (job: number) => task.seeds.filter((_, i) => i % jobs === job);
  await Promise.all(
    Array.from({ length: jobs }, (_, job) => {
      const worker = new Worker(new URL(import.meta.url), { workerData: { ...task, seeds: share(job) } satisfies Task });
      return new Promise<void>((resolve, reject) => {
        worker.on('message', (decision: Decision | null) => {
          if (decision === null) return void worker.terminate().then(() => resolve());
          decisions.push(decision);
          if (process.stderr.isTTY) process.stderr.write(`\r${decisions.length} of ${task.seeds.length} `);
        });
        worker.on('error', reject);
      });
    }),
  );
  return decisions.sort((a, b) => a.seed - b.seed);
}

/** The strata for which the share of decided levels is reported; a level can be in several. */
const STRATA: readonly (readonly [name: string, has: (level: Level, seed: number) => boolean])[] = [
  ['all', () => true],
  ['not over at once', (level) => goesOn(level)],
  ['scattered', (_, seed) => layoutOf(seed) === 'scattered'],
  ['chained', (_, seed) => layoutOf(seed) === 'chained'],
  ['5 to 30 novae', ({ novae }) => novae.length <= 30],
  ['31 to 60 novae', ({ novae }) => novae.length > 30 && novae.length <= 60],
  ['61 to 90 novae', ({ novae }) => novae.length > 60 && novae.length <= 90],
  ['91 to 120 novae', ({ novae }) => novae.length > 90],
  ['1 to 3 asteroids', ({ asteroids }) => asteroids.length <= 3],
  ['4 to 8 asteroids', ({ asteroids }) => asteroids.length > 3 && asteroids.length <= 8],
  ['9 to 15 asteroids', ({ asteroids }) => asteroids.length > 8],
  ['aliens', ({ aliens }) => aliens.length > 0],
  ['no aliens', ({ aliens }) => aliens.length === 0],
  ['repulsors', ({ repulsors }) => repulsors.length > 0],
  ['hot asteroids', ({ asteroids }) => asteroids.some(({ hot }) => hot)],
  ['recoil', ({ recoil }) => recoil],
  ['starts at rest', ({ astronaut }) => astronaut.vx === 0 && astronaut.vy === 0],
  ['starts moving', ({ astronaut }) => astronaut.vx !== 0 || astronaut.vy !== 0],
  ['under 500,000 px2', (level) => areaOf(level) < 500_000],
  ['500,000 px2 and more', (level) => areaOf(level) >= 500_000],
];

/** Whether she survives the first tick, with the gun held or not. */
function goesOn(level: Level): boolean {
  const { asteroids, astronaut, range } = level;
  const inRange = asteroids.some(({ x, y }) => (x - astronaut.x) ** 2 + (y - astronaut.y) ** 2 <= range ** 2);
  const scene = compile(level);
  return inRange && [[], [[0, 60]] as const].some((holds) => simulate(scene, holds, { maxTime: 1 / 60 }).outcome === 'timeout');
}

/** Area of the bounding box of all objects, px². */
function areaOf({ astronaut, blackHole, asteroids, novae }: Level): number {
  const all = [astronaut, blackHole, ...asteroids, ...novae];
  const span = (values: number[]) => Math.max(...values) - Math.min(...values);
  return span(all.map(({ x }) => x)) * span(all.map(({ y }) => y));
}

function tell(decisions: readonly Decision[], task: Task): void {
  const count = (of: readonly Decision[], verdict: Decision['verdict']) => of.filter((d) => d.verdict === verdict).length;
  const rows = STRATA.map(([name, has]) => {
    const here = decisions.filter(({ seed }) => has(levelOf(seed), seed));
    const undecided = count(here, 'undecided');
    const share = here.length === 0 ? null : `${((100 * (here.length - undecided)) / here.length).toFixed(2)} %`;
    return [name, here.length, count(here, 'completable'), count(here, 'impossible'), undecided, share];
  });
  const proofs = new Map<string, number>();
  for (const { verdict, proof } of decisions) {
    if (verdict === 'impossible' && proof !== null) proofs.set(proof, (proofs.get(proof) ?? 0) + 1);
  }
  const undecided = decisions.filter(({ verdict }) => verdict === 'undecided');
  const wrong = decisions.filter(({ proof }) => proof === 'REFUTED' || proof?.startsWith('unverified'));
  const share = (decisions.length - undecided.length) / Math.max(1, decisions.length);
  const claims: Claim[] = [
    { what: 'levels undecided, share', limit: 0.01, measured: 1 - share, met: share >= 0.99 },
    { what: 'proofs refuted or not verified', limit: 0, measured: wrong.length, met: wrong.length === 0 },
  ];
  const searched = decisions.filter(({ verdict }) => verdict === 'completable').map(({ ticks }) => ticks);
  searched.sort((a, b) => a - b);
  const refuted = decisions.filter(({ verdict, ticks }) => verdict === 'impossible' && ticks > 0);
  publish({
    title: `Random set: decided at ${task.accuracy}, up to ${task.searches} searches of ${task.budget} ticks a level`,
    columns: ['levels', 'number', 'completable', 'impossible', 'undecided', 'decided'],
    rows,
    claims,
    notes: [
      `Proofs: ${[...proofs].map(([code, n]) => `${code} ${n}`).join(', ') || 'none'}.`,
      `Ticks to the first run: median ${searched[searched.length >> 1] ?? '-'}, most ${searched.at(-1) ?? '-'}.`,
      ...(refuted.length > 0
        ? [`Searched against a proof: ${refuted.length} levels, ${refuted.reduce((sum, { ticks }) => sum + ticks, 0)} ticks.`]
        : []),
      ...(undecided.length > 0 ? [`Undecided: ${inCommon(undecided)}.`] : []),
      ...undecided.map((d) => `undecided ${d.seed}: ${aboutLevel(d)}`),
      ...wrong.map(({ seed, proof }) => `WRONG ${seed}: ${proof}`),
    ],
  });
}

/** What undecided levels have in common: how she starts, whether asteroids move, and how far she gets. */
function inCommon(undecided: readonly Decision[]): string {
  const kinds = new Map<string, number>();
  for (const { seed, squares } of undecided) {
    const { astronaut, recoil } = levelOf(seed);
    const start = astronaut.vx !== 0 || astronaut.vy !== 0 ? 'moving' : 'at rest';
    const kind = `${start}${recoil ? ', recoil' : ''}, ${squares <= FEW_SQUARES ? 'soon over' : 'roams'}`;
    kinds.set(kind, (kinds.get(kind) ?? 0) + 1);
  }
  return [...kinds]
    .sort(([, a], [, b]) => b - a)
    .map(([kind, n]) => `${kind} ${n}`)
    .join('; ');
}

/** Facts that may explain why a level is undecided. */
function aboutLevel({ seed, closest, squares, ticks }: Decision): string {
  const level = levelOf(seed);
  const parts = [
    layoutOf(seed),
    `${level.asteroids.length} asteroids`,
    `${level.novae.length} novae`,
    `${level.aliens.length} aliens`,
    `${level.repulsors.length} repulsors`,
    ...(level.recoil ? ['recoil'] : []),
    ...(level.astronaut.vx !== 0 || level.astronaut.vy !== 0 ? ['moving'] : []),
    `${squares} squares`,
    `closest ${closest === null ? '-' : closest.toFixed(1)} px in ${ticks} ticks`,
  ];
  return parts.join(', ');
}

async function main(): Promise<void> {
  const accuracy = optionValue('--accuracy') ?? DEFAULT_ACCURACY;
  if (!isAccuracyName(accuracy))
    throw new RangeError(`--accuracy: expected arcade, fast, standard or precise, found ${accuracy}`);
  const from = Number(optionValue('--from') ?? 0);
  const levels = Number(optionValue('--levels') ?? RANDOM_SET_SIZE);
  const named = optionValue('--seeds')?.split(',').map(Number);
  const seeds = named ?? Array.from({ length: Math.min(levels, RANDOM_SET_SIZE - from) }, (_, i) => from + i);
  const budget = Number(optionValue('--budget') ?? 20_000_000);
  const searches = Number(optionValue('--searches') ?? 4);
  const task: Task = { seeds, accuracy, budget, searches, refuteMs: 0 };
  const jobs = Number(optionValue('--jobs') ?? 1);

  const hash = hashRandomSet();
  if (hash !== RANDOM_SET_HASH) throw new Error(`the random set has changed: expected ${RANDOM_SET_HASH}, found ${hash}`);
  const decisions = await decideAll(task, jobs);
  const refute = Number(optionValue('--refute') ?? 0);
  if (refute > 0) {
    // every n-th of those proved impossible, so that the sample spans the set
    const impossible = decisions.filter(({ verdict }) => verdict === 'impossible').map(({ seed }) => seed);
    const step = Math.max(1, impossible.length / refute);
    const sample = Array.from({ length: Math.min(refute, impossible.length) }, (_, i) => impossible[Math.floor(i * step)]);
    const refuteMs = 1000 * Number(optionValue('--refute-seconds') ?? 60);
    const again = new Map((await decideAll({ ...task, seeds: sample, refuteMs }, jobs)).map((d) => [d.seed, d]));
    tell(
      decisions.map((d) => again.get(d.seed) ?? d),
      task,
    );
    return;
  }
  tell(decisions, task);
}

if (isMainThread) await main();
else work(workerData as Task);
