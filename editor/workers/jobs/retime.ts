import { compile } from '../../../engine/index.ts';
import { createRetime } from '../../../solver/index.ts';
import type { Retiming } from '../protocol.ts';
import { createPacer, type Start } from '../work.ts';

/** Re-times a run, and reports every better result at once. */
export const retime: Start<'retime'> = function* ({ level, terms, holds, effort, ...options }, now) {
  const retiming = createRetime(compile(level, terms), holds, options);
  const found = (): Retiming => ({
    best: retiming.best,
    effort: { ...retiming.effort },
    finished: retiming.finished,
  });
  const pace = createPacer(now);
  let told = retiming.best;
  // what remains once the slack is known has a limit of its own
  while (!retiming.finished && (retiming.effort.ticks < effort || retiming.best?.slack)) {
    pace((ticks) => retiming.advance(ticks));
    const isNews = retiming.best !== told;
    told = retiming.best;
    yield isNews ? found() : null;
  }
  return found();
};
