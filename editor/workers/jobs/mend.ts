import { createMend } from '../../../check/index.ts';
import type { Mending } from '../protocol.ts';
import { createPacer, type Start } from '../work.ts';

/** Seeks what mends a level, and reports all of it with each find. */
export const mend: Start<'mend'> = function* (options, now) {
  const mending = createMend(options);
  const found = (): Mending => ({ found: mending.found, effort: mending.effort, finished: mending.finished });
  const pace = createPacer(now);
  let told = mending.found;
  while (!mending.finished) {
    pace((ticks) => mending.advance(ticks));
    const isNews = mending.found !== told;
    told = mending.found;
    yield isNews ? found() : null;
  }
  return found();
};
