import { compile } from '../../../engine/index.ts';
import type { Hold } from '../../../schema/index.ts';
import { createRetime, type Effort, type Retimed } from '../../../solver/index.ts';
import { createPacer, job, type Played, type Work } from '../job.ts';

/** What was found to keep a run alive. */
export interface Retiming {
  /** null: nothing so far */
  readonly best: Retimed | null;
  readonly effort: Effort;
  /** Whether all was tried; false: the effort was spent. */
  readonly finished: boolean;
}

/** Small shifts of a run's presses and releases with which it completes the level, with so much effort, ticks. */
export const retime = job<
  Played & {
    readonly holds: readonly Hold[];
    /** Indices of the minerals to keep. */
    readonly minerals: readonly number[];
    /** Holds that worked a moment ago; null: none. */
    readonly warm: readonly Hold[] | null;
    readonly within: number;
    /** The tick in which the run ended before. */
    readonly formerEnd: number;
    readonly effort: number;
    readonly certifies: boolean;
  },
  Retiming,
  Retiming
>({ name: 'retime', lane: 'long', most: 20_000 });

/** Re-times a run, and reports every better result at once. */
export const retimeWork: Work<typeof retime> = {
  of: retime,
  *steps({ level, terms, holds, effort, ...options }, now) {
    const retiming = createRetime(compile(level, terms), holds, options);
    const found = (): Retiming => ({
      best: retiming.best,
      effort: { ...retiming.effort },
      finished: retiming.finished,
    });
    const pace = createPacer(now);
    let reported = retiming.best;
    // what remains once the slack is known has a limit of its own
    while (!retiming.finished && (retiming.effort.ticks < effort || retiming.best?.slack)) {
      pace((ticks) => retiming.advance(ticks));
      const isNews = retiming.best !== reported;
      reported = retiming.best;
      yield isNews ? found() : null;
    }
    return found();
  },
};
