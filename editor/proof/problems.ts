import {
  ACCURACIES,
  type AccuracyName,
  compile,
  createSimulation,
  DEFAULT_MAX_TIME,
  findWarnings,
  joinHolds,
  playScript,
  type Run,
  TICK,
  TICK_RATE,
} from '../../engine/index.ts';
import type { Hold, Level, Problem } from '../../schema/index.ts';
import { outcomeInWords, type RunEnd } from './outcome.ts';
import { type Limit, limitInWords } from './patience.ts';

type Placeless = Omit<Problem, 'line' | 'column'>;

const MAX_TICKS = Math.round(DEFAULT_MAX_TIME * TICK_RATE);

const NO_RUN: Placeless = {
  code: 'no-run',
  severity: 'error',
  message: 'the level has no run, so nothing shows that it can be completed',
  hint: 'play it and make the attempt the proof, or let the solver look for a run',
  pointer: '',
};

/** What is said in place of problems that are not known. */
export const limitProblem = (limit: Limit): Problem => ({
  code: 'work-limit',
  severity: 'warning',
  message: limitInWords(limit),
  hint: limit === 'unchecked' ? 'turn the checks on to have it played' : 'take out objects, aliens above all, or runs',
  pointer: '',
  line: null,
  column: null,
});

function failedRun(level: Level, index: number, run: RunEnd, noneCompletes: boolean): Placeless {
  return {
    code: 'run-does-not-complete',
    severity: noneCompletes ? 'error' : 'warning',
    message: `run ${JSON.stringify(level.runs[index].name)} ${outcomeInWords(run, level.range)}`,
    hint: noneCompletes
      ? 'move what is in the way, or change the run'
      : 'another run completes the level: mend this one or take it out',
    pointer: `/runs/${index}`,
  };
}

function endsUnder(level: Level, accuracy: AccuracyName): RunEnd[] {
  const simulation = createSimulation(compile(level, accuracy));
  return level.runs.map(({ holds }) => {
    simulation.reset();
    playScript(simulation, joinHolds(holds), MAX_TICKS);
    return simulation.ending ?? { outcome: 'timeout', with: null, time: MAX_TICKS * TICK, tick: MAX_TICKS };
  });
}

/** Runs that complete the level at some accuracies and not at others. As in a check, all are played only where the coarsest and the finest don't agree. */
function hangsOnAccuracy(level: Level, accuracy: AccuracyName, runs: readonly RunEnd[]): Placeless[] {
  if (runs.length === 0) return [];
  const ends = new Map<AccuracyName, readonly RunEnd[]>([[accuracy, runs]]);
  const agree = (index: number): boolean =>
    new Set([...ends.values()].map((list) => list[index].outcome === 'completed')).size === 1;
  for (const name of ['arcade', 'precise'] as const) if (!ends.has(name)) ends.set(name, endsUnder(level, name));
  if (runs.every((_, index) => agree(index))) return [];
  for (const name of Object.keys(ACCURACIES) as AccuracyName[]) if (!ends.has(name)) ends.set(name, endsUnder(level, name));
  return runs.flatMap((_, index) => {
    if (agree(index)) return [];
    const all = [...ends].map(([name, list]) => ({ name, end: list[index] }));
    const good = all.filter(({ end }) => end.outcome === 'completed').map(({ name }) => name);
    const bad = all.filter(({ end }) => end.outcome !== 'completed');
    const failures = bad.map(({ name, end }) => `${name} (${outcomeInWords(end, level.range)})`);
    return [
      {
        code: 'verdict-hangs-on-accuracy',
        severity: 'warning' as const,
        message: `run ${JSON.stringify(level.runs[index].name)} completes the level under ${good.join(', ')}, but not under ${failures.join(', ')}`,
        hint: 'it hangs by a hair: give it more room, or change the run',
        pointer: `/runs/${index}`,
      },
    ];
  });
}

/**
 * What is wrong with a valid level and its runs, and what looks wrong: what `gq check` finds, errors first.
 * @param simulated a run of the level at that accuracy, in full
 */
export function problemsOf(level: Level, accuracy: AccuracyName, simulated: (holds: readonly Hold[]) => Run): Problem[] {
  const runs = level.runs.map(({ holds }) => simulated(holds));
  const noneCompletes = runs.every(({ outcome }) => outcome !== 'completed');
  const failed = runs.flatMap((run, index) => (run.outcome === 'completed' ? [] : [failedRun(level, index, run, noneCompletes)]));
  const found: Placeless[] = [
    ...(runs.length === 0 ? [NO_RUN] : []),
    ...failed,
    ...hangsOnAccuracy(level, accuracy, runs),
    ...findWarnings(level, runs),
  ];
  return found.map((problem) => ({ ...problem, line: null, column: null }));
}
