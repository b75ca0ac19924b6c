import type { VerifiedPlay } from '../../game/index.ts';
import { openPool } from '../io/index.ts';
import { type ReplayTask, replayAll } from './replay.ts';

/** Fewer plays than this are replayed before a thread has started. */
const FEW = 512;

/** Replays plays here, and in worker threads once there are many. */
export interface Threads {
  /** How many batches may be under way at once. */
  readonly most: number;
  replay(tasks: readonly ReplayTask[]): Promise<(VerifiedPlay | null)[]>;
  end(): Promise<void>;
}

/** @param jobs the largest number of threads; with 1, everything is done here */
export function startThreads(jobs: number): Threads {
  // a promise: several batches ask for it before it is open
  let pool: ReturnType<typeof openPool> | null = null;
  let seen = 0;
  return {
    most: 2 * jobs,
    async replay(tasks) {
      seen += tasks.length;
      if (jobs === 1 || seen <= FEW) return replayAll(tasks);
      pool ??= openPool(new URL('./worker.js', import.meta.url), jobs);
      return (await pool).run(tasks);
    },
    async end() {
      await (await pool)?.destroy();
    },
  };
}
