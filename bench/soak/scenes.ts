import { isMainThread, parentPort, Worker, workerData } from 'node:worker_threads';
import { checkMixed } from '../../tests/judges/check-mixed.ts';
import { checkScene, type Finding } from '../../tests/judges/check-scene.ts';
import { checkPieces } from '../../tests/judges/pieces.ts';
import { degenerateScene } from '../../tests/scenes/degenerate-scene.ts';
import { mixedScene } from '../../tests/scenes/mixed-scene.ts';
import { randomScene } from '../../tests/scenes/random-scene.ts';
import { startScene } from '../../tests/scenes/start-scene.ts';
import { windyDegenerateScene, windyScene } from '../../tests/scenes/windy-scene.ts';
import type { Attacked, Span } from './span.ts';

/**
 * What is examined for each seed: `rules` in any scene, `pieces` in scenes where something may happen endlessly; both also with
 * winds and wormholes. `mixed`: all effects and rules at once, against the reference; `starts`: what is decided at time 0.
 */
export const SCENES = {
  rules: { scene: randomScene, find: (seed: number) => checkScene(randomScene(seed), seed) },
  'windy-rules': { scene: windyScene, find: (seed: number) => checkScene(windyScene(seed), seed) },
  mixed: { scene: mixedScene, find: (seed: number) => checkMixed(mixedScene(seed), seed) },
  starts: { scene: startScene, find: (seed: number) => checkMixed(startScene(seed), seed) },
  pieces: { scene: degenerateScene, find: (seed: number) => checkPieces(degenerateScene(seed)) },
  'windy-pieces': { scene: windyDegenerateScene, find: (seed: number) => checkPieces(windyDegenerateScene(seed)) },
};
export type SceneAttack = keyof typeof SCENES;

/** A scene that takes longer than this hangs, ms. */
const HANGS_AFTER = 60_000;

interface Task {
  readonly attack: SceneAttack;
  readonly from: number;
  readonly to: number;
  /** The seed of the scene being checked, for the watching thread. */
  readonly current: Int32Array;
}

type Found = Finding & { readonly scene: number };

/** Checks one scene after the other. Posts each finding, and null at the end. */
function work({ attack, from, to, current }: Task): void {
  for (let scene = from; scene < to; scene++) {
    Atomics.store(current, 0, scene);
    for (const finding of SCENES[attack].find(scene)) parentPort?.postMessage({ ...finding, scene });
  }
  Atomics.store(current, 0, to);
  parentPort?.postMessage(null);
}

/** Runs scenes in a worker. A worker that hangs is ended, and another one is started after that scene. */
async function watch(
  attack: SceneAttack,
  from: number,
  to: number,
  until: number,
  report: (found: Found) => void,
): Promise<number> {
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

/** Checks one scene after the other in a worker. */
export async function attackScenes(attack: SceneAttack, { from, most, until }: Span): Promise<Attacked> {
  const began = Date.now();
  const counts = { bug: 0, hangs: 0, excluded: 0 };
  const reasons = new Map<string, number>();
  const done = await watch(attack, from, from + most, until, (found) => {
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
  }[attack === 'starts' ? 'mixed' : attack.replace('windy-', '')];
  return {
    tried: done - from,
    bugs: counts.bug,
    told: `scenes ${from} to ${done - 1} in ${((Date.now() - began) / 1000).toFixed(1)} s: ${left}`,
  };
}

if (!isMainThread) work(workerData as Task);
