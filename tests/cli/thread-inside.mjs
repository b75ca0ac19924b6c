// Takes the place of `node:worker_threads` in a thread that runs in the main thread: see shared-threads.mjs.
import { insideOf } from './shared-threads.mjs';

export const { parentPort, workerData } = insideOf(new URL(import.meta.url).searchParams.get('thread'));
