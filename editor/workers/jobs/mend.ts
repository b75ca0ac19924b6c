import { createMend, type Mended, type MendOptions } from '../../../check/index.ts';
import type { Effort } from '../../../solver/index.ts';
import { createPacer, job, type Work } from '../job.ts';

/** What was found to mend a level. */
export interface Mending {
  readonly found: readonly Mended[];
  readonly effort: Effort;
  readonly finished: boolean;
}

/** What mends a level that a change has broken. */
export const mend = job<MendOptions, Mending, Mending>({ name: 'mend', lane: 'long', most: 60_000 });

/** Seeks what mends a level, and reports all of it with each find. */
export const mendWork: Work<typeof mend> = {
  of: mend,
  *steps(options, now) {
    const mending = createMend(options);
    const found = (): Mending => ({ found: mending.found, effort: mending.effort, finished: mending.finished });
    const pace = createPacer(now);
    let reported = mending.found;
    while (!mending.finished) {
      pace((ticks) => mending.advance(ticks));
      const isNews = mending.found !== reported;
      reported = mending.found;
      yield isNews ? found() : null;
    }
    return found();
  },
};
