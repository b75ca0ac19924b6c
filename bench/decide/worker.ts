import { parentPort, workerData } from 'node:worker_threads';
import type { NamedLevel } from '../harness/index.ts';
import { decide, type Effort } from './decide.ts';

const { levels, effort } = workerData as { levels: readonly NamedLevel[]; effort: Effort };
for (const level of levels) parentPort?.postMessage(decide(level, effort));
parentPort?.postMessage(null);
