import type { AccuracyHang } from '../accuracy-hangs.ts';
import { MOST_RUNS, type TightRun, wantedTicks } from '../certified-ticks.ts';
import type { ScriptEnd } from '../findings.ts';
import { type CheckCode, holdsInWords, outcomeInWords, plural } from '../words/index.ts';
import type { Hints, LevelProblem } from './problem.ts';

/** How a run was simulated. */
interface Played {
  /** Name of the accuracy. */
  readonly accuracy: string;
  /** Range of the level, px. */
  readonly range: number;
}

/**
 * The problem of a run that does not complete its level: an error when no run does, else a warning.
 * @param index index of the run in the level's list
 * @param isCompletable whether another run shows that the level can be completed
 */
export function failedRun(
  run: ScriptEnd,
  index: number,
  { accuracy, range }: Played,
  isCompletable: boolean,
  hints: Hints,
): LevelProblem<CheckCode> {
  const todo = isCompletable
    ? 'another run completes it: correct this one or delete it'
    : 'move what is in the way, or change the run';
  return {
    code: 'run-does-not-complete',
    severity: isCompletable ? 'warning' : 'error',
    message: `run ${JSON.stringify(run.name)} does not complete the level under ${accuracy}: ${outcomeInWords(run, range)}`,
    hint: `${todo}${hints.seeRun(run.name)}`,
    pointer: `/runs/${index}`,
  };
}

/**
 * The problem of a run that completes the level at some accuracies but not at others.
 * @param range range of the level, px
 */
export function hangingRun({ index, name, ends }: AccuracyHang, range: number, hints: Hints): LevelProblem<CheckCode> {
  const good = ends.filter(({ end }) => end.outcome === 'completed').map(({ accuracy }) => accuracy);
  const bad = ends
    .filter(({ end }) => end.outcome !== 'completed')
    .map(({ accuracy, end }) => `${accuracy} (${outcomeInWords(end, range)})`);
  return {
    code: 'verdict-hangs-on-accuracy',
    severity: 'warning',
    message: `run ${JSON.stringify(name)} completes the level under ${good.join(', ')}, but not under ${bad.join(', ')}`,
    hint: `the outcome is very close: give her more room, or change the run${hints.seeAccuracies(name)}`,
    pointer: `/runs/${index}`,
  };
}

/** The problem of a run with fewer certified ticks than required: an error when a number is required, else a warning. */
export function tightRun(run: TightRun, hint: string): LevelProblem<CheckCode> {
  const { name, ticks, required, pointer } = run;
  const wanted = wantedTicks(required);
  const message = run.isExhausted
    ? `${name}: ${MOST_RUNS} simulated runs did not prove that all its presses and releases may be off by ${plural(wanted, 'tick')}; they proved ${plural(ticks, 'tick')}`
    : `${name}: its presses and releases may all be off by ${plural(ticks, 'tick')}, but not by ${plural(ticks + 1, 'tick')}${exampleOf(run)}`;
  return {
    code: required === null ? 'low-slack' : 'slack-below-required',
    severity: required === null ? 'warning' : 'error',
    message: required === null ? message : `${message}; required: ${wanted}`,
    hint,
    pointer,
  };
}

const exampleOf = ({ holds, counterexample }: TightRun): string =>
  counterexample === null ? '' : `: ${holdsInWords(counterexample)} instead of ${holdsInWords(holds)} fails`;
