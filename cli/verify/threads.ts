import type { VerifiedPlay } from '../../game/index.ts';
import { catchSignals } from '../signals.ts';
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

interface Pool {
  run(tasks: readonly ReplayTask[]): Promise<(VerifiedPlay | null)[]>;
  destroy(): Promise<void>;
}

/** @param jobs the largest number of threads; with 1, everything is done here */
export function startThreads(jobs: number): Threads {
  let pool: Pool | null = null;
  let seen = 0;
  const startPool = async (): Promise<Pool> => {
    const { Tinypool } = await import('tinypool');
    catchSignals();
    const filename = new URL('./worker.js', import.meta.url).href;
    return new Tinypool({ filename, minThreads: jobs, maxThreads: jobs, isolateWorkers: false });
  };
  return {
    most: 2 * jobs,
    async replay(tasks) {
      seen += tasks.length;
      if (jobs === 1 || seen <= FEW) return replayAll(tasks);
      pool ??= await startPool();
      return pool.run(tasks);
    },
    async end() {
      await pool?.destroy();
    },
  };
}
