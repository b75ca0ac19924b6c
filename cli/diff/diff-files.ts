import { isSame, RULE_NAMES } from '../../schema/index.ts';
import { runInPool } from '../io/index.ts';
import type { Comparison, Pair } from './comparison.ts';
import type { DiffedLevel, DiffSettings, DiffTask } from './diffed-level.ts';
import { pairRenamed } from './pair-renamed.ts';

/** Fewer levels than this are compared faster without workers. */
const MANY_LEVELS = 12;

/** A rule that the configurations of the two sides set differently. */
export interface RuleChange {
  readonly rule: string;
  /** undefined: the original game's value. */
  readonly before: number | undefined;
  readonly after: number | undefined;
}

/** The result of a comparison. */
export interface Diff {
  readonly comparison: Comparison;
  readonly rules: readonly RuleChange[];
  /** Under which each side was judged. */
  readonly terms: DiffSettings['terms'];
  /** The levels that differ, sorted by path. */
  readonly levels: readonly DiffedLevel[];
  /** The pairs of files behind `levels`, in the same order. */
  readonly pairs: readonly Pair[];
  /** Level files that are equal, and whose levels play as before although the terms differ. */
  readonly same: number;
}

/** Compares all files of a comparison. @param jobs the largest number of worker threads */
export async function diffFiles(comparison: Comparison, settings: DiffSettings, jobs: number): Promise<Diff> {
  const { terms } = settings;
  const rules = { before: terms.before.rules, after: terms.after.rules };
  const pathOf = ({ before, after }: Pair): string => (after ?? before)?.path ?? '';
  const pairs = [...pairRenamed(comparison.pairs), ...comparison.equal.map((file): Pair => ({ before: file, after: file }))].sort(
    (p, q) => (pathOf(p) < pathOf(q) ? -1 : 1),
  );
  const tasks = pairs.map((pair): DiffTask => ({ pair, settings }));
  const levels = await diffAll(tasks, jobs);
  const isShown = ({ status, effects }: DiffedLevel): boolean => status !== 'rules' || effects.length > 0;
  return {
    comparison,
    rules: RULE_NAMES.flatMap((rule): RuleChange[] =>
      isSame(rules.before[rule], rules.after[rule]) ? [] : [{ rule, before: rules.before[rule], after: rules.after[rule] }],
    ),
    terms,
    levels: levels.filter(isShown),
    pairs: pairs.filter((_, i) => isShown(levels[i])),
    same: levels.filter((level) => !isShown(level)).length,
  };
}

async function diffAll(tasks: readonly DiffTask[], jobs: number): Promise<DiffedLevel[]> {
  if (tasks.length < MANY_LEVELS || jobs === 1) {
    const { diffLevel } = await import('./diff-level.ts');
    return tasks.map(diffLevel);
  }
  return runInPool<DiffTask, DiffedLevel>(new URL('./worker.js', import.meta.url), tasks, jobs, () => {});
}
