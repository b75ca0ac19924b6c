import { isMainThread, parentPort, Worker, workerData } from 'node:worker_threads';
import { optionValue } from './harness.ts';
import { attackProofs } from './soak/attack-proofs.ts';
import { checkScene, type Finding } from './soak/check-scene.ts';
import { randomScene } from './soak/random-scene.ts';

/** A scene that takes longer than this does not go on, ms. */
const HANGS_AFTER = 20_000;

interface Task {
  readonly from: number;
  readonly to: number;
  /** The scene being checked, for the one who watches. */
  readonly current: Int32Array;
}

interface Found extends Finding {
  readonly scene: number;
}

/** Checks scene after scene; what is found is posted, and null at the end. */
function work({ from, to, current }: Task): void {
  for (let scene = from; scene < to; scene++) {
    Atomics.store(current, 0, scene);
    for (const finding of checkScene(randomScene(scene), scene)) parentPort?.postMessage({ ...finding, scene });
  }
  Atomics.store(current, 0, to);
  parentPort?.postMessage(null);
}

/** Runs scenes in a worker that is ended when one of them hangs, and started again after it. */
async function watch(from: number, to: number, until: number, report: (found: Found) => void): Promise<number> {
  const current = new Int32Array(new SharedArrayBuffer(4));
  for (let next = from; next < to; ) {
    current[0] = next;
    const worker = new Worker(new URL(import.meta.url), { workerData: { from: next, to, current } satisfies Task });
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

async function main(): Promise<void> {
  const only = optionValue('--only');
  if (only !== null) {
    const scene = randomScene(Number(only));
    console.log(JSON.stringify(scene));
    console.log(JSON.stringify(checkScene(scene, Number(only)), null, 2));
    return;
  }
  const part = optionValue('--part');
  if (part !== 'proofs') await soakScenes();
  if (part !== 'scenes') attackProofs();
}

async function soakScenes(): Promise<void> {
  const from = Number(optionValue('--from') ?? 0);
  const scenes = Number(optionValue('--scenes') ?? 100_000);
  const seconds = Number(optionValue('--seconds') ?? 3600);
  const began = Date.now();
  const counts = { bug: 0, hangs: 0 };
  const done = await watch(from, from + scenes, began + 1000 * seconds, (found) => {
    counts[found.kind]++;
    console.log(`${found.kind}  scene ${found.scene}  ${found.accuracy}: ${found.what}`);
  });
  console.log(
    `\n${done - from} scenes (${from} to ${done - 1}) at three accuracies in ${((Date.now() - began) / 1000).toFixed(1)} s: ` +
      `${counts.bug} bugs, ${counts.hangs} whose outcome hangs on their last digits`,
  );
  if (counts.bug > 0 || done === from) process.exitCode = 1;
}

if (isMainThread) await main();
else work(workerData as Task);
