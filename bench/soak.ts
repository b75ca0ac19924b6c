import { isMainThread, parentPort, Worker, workerData } from 'node:worker_threads';
import { checkBySteps } from '../tests/judges/by-steps.ts';
import { checkMixed, shrinkMixed } from '../tests/judges/check-mixed.ts';
import { checkScene, type Finding } from '../tests/judges/check-scene.ts';
import { checkGraze, GRAZED_AT, graze } from '../tests/judges/contacts.ts';
import { checkPieces } from '../tests/judges/pieces.ts';
import { degenerateScene } from '../tests/scenes/degenerate-scene.ts';
import { mixedScene } from '../tests/scenes/mixed-scene.ts';
import { randomScene } from '../tests/scenes/random-scene.ts';
import { steppableScene, windyDegenerateScene, windyScene } from '../tests/scenes/windy-scene.ts';
import { optionValue } from './harness.ts';
import { attackProofs } from './soak/attack-proofs.ts';
import { attackProperties } from './soak/attack-properties.ts';
import { attackSignals } from './soak/attack-signals.ts';
import { attackWriters } from './soak/attack-writers.ts';

/**
 * What is examined for each seed: `rules` in any scene, `pieces` in scenes where something may happen endlessly; both also with
 * winds and wormholes. `mixed`: all effects and rules at once, against the reference.
 */
const ATTACKS = {
  rules: { scene: randomScene, find: (seed: number) => checkScene(randomScene(seed), seed) },
  'windy-rules': { scene: windyScene, find: (seed: number) => checkScene(windyScene(seed), seed) },
  mixed: { scene: mixedScene, find: (seed: number) => checkMixed(mixedScene(seed), seed) },
  pieces: { scene: degenerateScene, find: (seed: number) => checkPieces(degenerateScene(seed)) },
  'windy-pieces': { scene: windyDegenerateScene, find: (seed: number) => checkPieces(windyDegenerateScene(seed)) },
};
type Attack = keyof typeof ATTACKS;

/** A scene that takes longer than this hangs, ms. */
const HANGS_AFTER = 60_000;

interface Task {
  readonly attack: Attack;
  readonly from: number;
  readonly to: number;
  /** The seed of the scene being checked, for the watching thread. */
  readonly current: Int32Array;
}

interface Found extends Finding {
  readonly scene: number;
}

/** Checks one scene after the other. Posts each finding, and null at the end. */
function work({ attack, from, to, current }: Task): void {
  for (let scene = from; scene < to; scene++) {
    Atomics.store(current, 0, scene);
    for (const finding of ATTACKS[attack].find(scene)) parentPort?.postMessage({ ...finding, scene });
  }
  Atomics.store(current, 0, to);
  parentPort?.postMessage(null);
}

/** Runs scenes in a worker. A worker that hangs is ended, and another one is started after that scene. */
async function watch(attack: Attack, from: number, to: number, until: number, report: (found: Found) => void): Promise<number> {
  const current = new Int32Array(new SharedArrayBuffer(4));
  for (let next = from; next < to; ) {
    current[0] = next;
    const worker = new Worker(new URL(import.meta.url), {
      workerData: { attack, from: next, to, current } satisfies Task,
      // the reference leaves much behind, all of it soon
      resourceLimits: { maxYoungGenerationSizeMb: 128 },
    });
    next = await new Promise<number>((resolve) => {
      let seen = next;
      let since = Date.now();
      const stop = (result: number) => {
        clearInterval(timer);
        void worker.terminate().then(() => resolve(result));
      };
      const timer = setInterval(() => {
        const now = Atomics.load(current, 0);
        if (now !== seen) {
          seen = now;
          since = Date.now();
        } else if (Date.now() - since > HANGS_AFTER) {
          report({ scene: now, kind: 'bug', accuracy: 'any', what: `does not end in ${HANGS_AFTER / 1000} s` });
          stop(now + 1);
        }
        if (Date.now() > until) stop(-now);
      }, 100);
      worker.on('message', (found: Found | null) => {
        if (found === null) stop(to);
        else report(found);
      });
      worker.on('error', (error) => {
        report({ scene: Atomics.load(current, 0), kind: 'bug', accuracy: 'any', what: `worker: ${error.message}` });
        stop(Atomics.load(current, 0) + 1);
      });
    });
    if (next < 0) return -next;
  }
  return to;
}

/** Checks that objects which she touches or misses by 1e-9 to 1 px are found or not, seed by seed. */
function attackContacts(from: number, seeds: number, until: number): void {
  const counts = { hit: 0, missed: 0, vague: 0, bug: 0 };
  let seed = from;
  for (; seed < from + seeds && Date.now() < until; seed++) {
    for (const accuracy of GRAZED_AT) {
      const made = graze(seed, accuracy);
      if (made === null) continue;
      const finding = checkGraze(made);
      counts[finding.what]++;
      if (finding.what === 'bug') console.log(`bug  graze ${seed}: ${finding.why}`);
    }
  }
  console.log(
    `\n${seed - from} seeds (${from} to ${seed - 1}): ${counts.hit} touches found, ${counts.missed} near misses left alone, ` +
      `${counts.vague} that overlap at the start, ${counts.bug} bugs`,
  );
  if (counts.bug > 0 || counts.hit === 0) process.exitCode = 1;
}

/** Checks that the engine agrees with another program that makes small steps, seed by seed. */
function attackBySteps(from: number, seeds: number, until: number): void {
  const counts = { agrees: 0, vague: 0, bug: 0 };
  let jumps = 0;
  let crossings = 0;
  let seed = from;
  for (; seed < from + seeds && Date.now() < until; seed++) {
    const finding = checkBySteps(steppableScene(seed));
    counts[finding.what]++;
    if (finding.what === 'bug') console.log(`bug  steppable scene ${seed}: ${finding.why}`);
    if (finding.what !== 'agrees') continue;
    jumps += finding.jumps;
    crossings += finding.crossings;
  }
  console.log(
    `\n${seed - from} scenes (${from} to ${seed - 1}): ${counts.agrees} agree, with ${jumps} jumps and ${crossings} rims of winds crossed, ` +
      `${counts.vague} about which small steps say nothing, ${counts.bug} bugs`,
  );
  if (counts.bug > 0 || counts.agrees === 0) process.exitCode = 1;
}

/** Checks one scene after the other in a worker. */
async function attackScenes(attack: Attack, from: number, scenes: number, seconds: number): Promise<void> {
  const began = Date.now();
  const counts = { bug: 0, hangs: 0, excluded: 0 };
  const reasons = new Map<string, number>();
  const done = await watch(attack, from, from + scenes, began + 1000 * seconds, (found) => {
    counts[found.kind]++;
    if (found.kind === 'excluded') reasons.set(found.what, (reasons.get(found.what) ?? 0) + 1);
    else console.log(`${found.kind}  scene ${found.scene}  ${found.accuracy}: ${found.what}`);
  });
  const share = ((100 * counts.excluded) / Math.max(1, done - from)).toFixed(1);
  const why = [...reasons].map(([reason, count]) => `${reason} ${count}`).join(', ');
  const left = {
    mixed: `${counts.excluded} (${share} %) not compared to the end: ${why}`,
    rules: `${counts.hangs} whose outcome hangs on their last digits`,
    pieces: `${counts.hangs} in clusters of asteroids`,
  }[attack.replace('windy-', '')];
  console.log(
    `\n${done - from} scenes (${from} to ${done - 1}) in ${((Date.now() - began) / 1000).toFixed(1)} s: ${counts.bug} bugs, ${left}`,
  );
  if (counts.bug > 0 || done === from) process.exitCode = 1;
}

const ALL_ATTACKS = [
  ...(Object.keys(ATTACKS) as Attack[]),
  'small-steps',
  'contacts',
  'properties',
  'proofs',
  'signals',
  'writers',
] as const;

const isScenes = (attack: string): attack is Attack => Object.hasOwn(ATTACKS, attack);

/** Runs every attack in turn, or the one named by `--attack`, each for at most `--seconds`. */
async function main(): Promise<void> {
  const named = optionValue('--attack');
  if (named !== null && !ALL_ATTACKS.some((attack) => attack === named)) {
    throw new Error(`--attack is one of ${ALL_ATTACKS.join(', ')}, not ${named}`);
  }
  const from = Number(optionValue('--from') ?? 0);
  const seeds = Number(optionValue('--scenes') ?? 100_000);
  const seconds = Number(optionValue('--seconds') ?? 900);
  const only = optionValue('--only');
  if (only !== null) {
    const attack = named !== null && isScenes(named) ? named : 'rules';
    const { scene, find } = ATTACKS[attack];
    const seed = Number(only);
    const findings = find(seed);
    console.log(JSON.stringify(scene(seed)));
    console.log(JSON.stringify(findings, null, 2));
    const bug = findings.find(({ kind }) => kind === 'bug');
    if (attack === 'mixed' && bug !== undefined) console.log(`smaller: ${JSON.stringify(shrinkMixed(scene(seed), seed, bug))}`);
    return;
  }
  for (const attack of named === null ? ALL_ATTACKS : [named]) {
    console.log(`\n== ${attack}`);
    if (isScenes(attack)) await attackScenes(attack, from, seeds, seconds);
    else if (attack === 'small-steps') attackBySteps(from, seeds, Date.now() + 1000 * seconds);
    else if (attack === 'contacts') attackContacts(from, seeds, Date.now() + 1000 * seconds);
    else if (attack === 'signals') await attackSignals(from, seeds, Date.now() + 1000 * seconds);
    else if (attack === 'writers') await attackWriters(from, seeds, Date.now() + 1000 * seconds);
    else if (attack === 'properties') attackProperties(from, Date.now() + 1000 * seconds);
    else attackProofs(seconds);
  }
}

if (isMainThread) await main();
else work(workerData as Task);
