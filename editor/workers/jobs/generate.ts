import { createGenerator } from '../../../solver/index.ts';
import { createPacer, type Start } from '../work.ts';

/** Generates a level from a seed; runs until it succeeds. */
export const generate: Start<'generate'> = function* ({ options }, now) {
  const generator = createGenerator(options);
  const pace = createPacer(now);
  let reported = 0;
  while (generator.result === null) {
    pace((ticks) => generator.advance(ticks));
    const { attempts } = generator.effort;
    yield attempts === reported ? null : { attempts };
    reported = attempts;
  }
  const { level, grade } = generator.result;
  return { file: level, grade: grade.value };
};
