import { parentPort, workerData } from 'node:worker_threads';
import { openLanes } from './lanes.ts';
import type { Answer, Request, WorkerData } from './settings.ts';

const { settings, lanes, stop } = workerData as WorkerData;
const stopped = new Int32Array(stop);
const own = openLanes(settings, lanes, () => Atomics.load(stopped, 0) !== 0);

function answer(request: Request): Answer {
  switch (request.kind) {
    case 'advance':
      return { kind: 'advance', lanes: own.advance(request.round) };
    case 'measure':
      return { kind: 'measure', robustness: own.measure(request.holds) };
  }
}

parentPort?.on('message', (request: Request) => {
  try {
    parentPort?.postMessage(answer(request));
  } catch (error) {
    parentPort?.postMessage({ kind: 'failed', why: error instanceof Error ? (error.stack ?? error.message) : String(error) });
  }
});
