import { parentPort, workerData } from 'node:worker_threads';
import { decide, type Effort, type NamedLevel } from './decide.ts';

const { levels, effort } = workerData as { levels: readonly NamedLevel[]; effort: Effort };
for (const level of levels) parentPort?.postMessage(decide(level, effort));
parentPort?.postMessage(null);
