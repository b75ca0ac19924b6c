import { compile, joinHolds } from '../../../engine/index.ts';
import { findSlackInSteps } from '../../../solver/index.ts';
import type { Start } from '../work.ts';

/** How far each press and release of a run may move alone. */
export const slack: Start<'slack'> = function* ({ level, accuracy, holds, goal }) {
  const steps = findSlackInSteps(compile(level, accuracy), joinHolds(holds), goal);
  for (;;) {
    const step = steps.next();
    if (step.done === true) return { slack: step.value };
    yield null;
  }
};
