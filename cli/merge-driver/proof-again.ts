import { playRuns } from '../../check/index.ts';
import { bodyInWords } from '../../check/words/index.ts';
import { compile, type Run, type Terms, WorkBudget } from '../../engine/index.ts';
import type { Level } from '../../schema/index.ts';

/** What a merge did to the runs of a level. */
export interface ProofAgain {
  /** For each run that completed the level before the merge and does not any more: what happens now. */
  readonly broken: readonly string[];
  /** Whether a run completed the level on both sides, and none does after the merge. */
  readonly isUnproved: boolean;
}

type Played = ReadonlyMap<string, Run>;

function play(level: Level, terms: Terms): Played {
  const runs = playRuns(compile(level, terms), new WorkBudget(terms.maxWork));
  return new Map(level.runs.map(({ name }, i) => [name, runs[i]]));
}

const completes = (run: Run | undefined): boolean => run?.outcome === 'completed' && run.stopped === null;

function endInWords({ outcome, with: touched, tick, time, stopped }: Run): string {
  if (stopped !== null) return 'costs more work than a check allows';
  switch (outcome) {
    case 'completed':
      return `completes it at tick ${tick}`;
    case 'collided':
      return `dies at tick ${tick}${touched === null ? '' : `, at ${bodyInWords(touched)}`}`;
    case 'lost':
      return `is lost at tick ${tick}`;
    case 'timeout':
      return `is not over after ${Number(time.toFixed(3))} s`;
  }
}

function beforeInWords(here: Run | undefined, there: Run | undefined): string {
  if (here !== undefined && there !== undefined)
    return here.tick === there.tick
      ? `completed at tick ${here.tick} on both sides`
      : `completed at tick ${here.tick} on our side and ${there.tick} on theirs`;
  return here === undefined ? `completed at tick ${there?.tick} on their side` : `completed at tick ${here.tick} on our side`;
}

/** Plays the runs of a merged level under some terms, and compares how they end with how they ended on both sides. */
export function playAgain(ours: Level, theirs: Level, merged: Level, terms: Terms): ProofAgain {
  const [here, there, now] = [ours, theirs, merged].map((level) => play(level, terms));
  const broken: string[] = [];
  for (const [name, run] of now) {
    const before = [here.get(name), there.get(name)];
    const known = before.filter((one) => one !== undefined);
    if (completes(run) || known.length === 0 || !known.every(completes)) continue;
    broken.push(`the run ${JSON.stringify(name)} now ${endInWords(run)} (before: ${beforeInWords(before[0], before[1])})`);
  }
  const some = (played: Played) => [...played.values()].some(completes);
  const isUnproved = some(here) && some(there) && !some(now);
  return { broken, isUnproved };
}
