import type { Run } from '../../engine/index.ts';
import type { Level, Problem } from '../../schema/index.ts';
import { outcomeInWords } from '../outcome.ts';

/** Of a level without runs. */
export const NO_RUN: Problem = {
  code: 'no-run',
  severity: 'error',
  message: 'the level has no run, so nothing shows that it can be completed',
  hint: 'add a run that completes it: "runs": [{ "name": "solution", "holds": [[press, release], ...] }], in ticks of 1/60 s',
  pointer: '',
  line: null,
  column: null,
};

interface FailedRun {
  readonly file: string;
  readonly level: Level;
  readonly accuracy: string;
  /** Of the run in the level's list. */
  readonly index: number;
  readonly run: Run;
  /** No run of the level completes it. */
  readonly noneCompletes: boolean;
}

/** Of a run that does not complete its level: an error when none does, a warning beside one that does. */
export function failedRun({ file, level, accuracy, index, run, noneCompletes }: FailedRun): Omit<Problem, 'line' | 'column'> {
  const name = JSON.stringify(level.runs[index].name);
  const path = /^[\w./\\:-]+$/.test(file) ? file : JSON.stringify(file);
  const todo = noneCompletes ? 'move what is in the way or change the run' : 'another run does: mend this one or take it out';
  return {
    code: 'run-does-not-complete',
    severity: noneCompletes ? 'error' : 'warning',
    message: `run ${name} does not complete the level under ${accuracy}: ${outcomeInWords(run, level)}`,
    hint: `${todo}; see gq simulate ${path} --run ${name}`,
    pointer: `/runs/${index}`,
  };
}
