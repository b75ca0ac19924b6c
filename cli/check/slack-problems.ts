import { joinHolds, type Run, type Scene } from '../../engine/index.ts';
import type { Hold, Level, Problem } from '../../schema/index.ts';
import { certify } from '../../solver/index.ts';
import { holdsInWords, plural } from '../report-parts/index.ts';
import type { CheckSettings } from './checked-level.ts';

/** Runs simulated at most to certify a run: where they don't suffice, what was asked for is not proved. */
const MOST_RUNS = 200_000;

/** A run that completes the level. */
interface CompletingRun {
  readonly holds: readonly Hold[];
  /** as a sentence begins */
  readonly name: string;
  readonly pointer: string;
}

/** Every run that completes a level: scripted ones, and the one that was found. */
export function completingRuns(
  level: Level,
  scripted: readonly Run[],
  found: { readonly holds: readonly Hold[] } | null,
): CompletingRun[] {
  const runs = level.runs.flatMap(({ name, holds }, i): CompletingRun[] =>
    scripted[i].outcome === 'completed' ? [{ holds, name: `run ${JSON.stringify(name)}`, pointer: `/runs/${i}` }] : [],
  );
  return found === null ? runs : [...runs, { holds: found.holds, name: 'the run that was found', pointer: '' }];
}

/**
 * Runs that forgive too little: an error where slack is required, a warning where levels are searched, too. Otherwise nobody
 * asked for the time it takes.
 */
export function slackProblems(
  scene: Scene,
  runs: readonly CompletingRun[],
  { requireSlack, search }: CheckSettings,
): Omit<Problem, 'line' | 'column'>[] {
  if (requireSlack === null && search === null) return [];
  return runs.flatMap((run) => slackProblem(scene, run, requireSlack) ?? []);
}

/** Of a run that does not forgive as much as it should; null when it does. Simulates every combination of shifts. */
function slackProblem(
  scene: Scene,
  { holds, name, pointer }: CompletingRun,
  required: number | null,
): Omit<Problem, 'line' | 'column'> | null {
  const wanted = required ?? 1;
  const goal = { minerals: 'any' } as const;
  const { ticks, exhausted, counterexample } = certify(scene, holds, goal, { limit: wanted, maxRuns: MOST_RUNS });
  if (ticks >= wanted) return null;
  const message = exhausted
    ? `${name}: that all its presses and releases may be off by ${plural(wanted, 'tick')} was not proved with ${MOST_RUNS} runs; ${plural(ticks, 'tick')} was`
    : `${name} may have its presses and releases off by ${plural(ticks, 'tick')}, not by ${plural(ticks + 1, 'tick')}${sayExample(holds, counterexample)}`;
  return {
    code: required === null ? 'low-slack' : 'slack-below-required',
    severity: required === null ? 'warning' : 'error',
    message: required === null ? message : `${message}; ${wanted} required`,
    hint: 'give her more room where it is tight (gq difficulty shows each edge), or look for a run that forgives more: gq solve',
    pointer,
  };
}

function sayExample(holds: readonly Hold[], counterexample: readonly Hold[] | null): string {
  if (counterexample === null) return '';
  return `: ${holdsInWords(joinHolds(counterexample))} instead of ${holdsInWords(holds)} fails`;
}
