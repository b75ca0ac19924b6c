import { isSame, OBJECT_LISTS, RULE_NAMES } from '../../schema/index.ts';
import { readContent } from '../../schema/level/index.ts';
import { runInPool } from '../io/index.ts';
import type { Comparison, DiffedLevel, DiffSettings, DiffTask, FileVersion, Pair } from './comparison.ts';

/** Fewer levels than this are compared faster without workers. */
const MANY_LEVELS = 12;

/** A rule that the configurations of the two sides set differently. */
interface RuleChange {
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

/** The least share of objects that a file and its new name have in common. */
const LEAST_SHARE = 0.5;

/** The ids of the objects in a level file; empty for one that is not valid. */
function idsOf({ bytes }: FileVersion): string[] {
  const read = readContent(bytes);
  if (!read.ok) return [];
  const { file } = read.document;
  return OBJECT_LISTS.flatMap((list) => (file[list] ?? []).flatMap(({ id }) => (id === undefined ? [] : [id])));
}

/**
 * Finds files that were removed under one name and added under another: they have the same content, or at least half of their
 * objects in common.
 */
function pairRenamed(pairs: readonly Pair[]): Pair[] {
  const removed = pairs.flatMap(({ before, after }) => (before !== null && after === null ? [before] : []));
  const added = pairs.flatMap(({ before, after }) => (before === null && after !== null ? [after] : []));
  if (removed.length === 0 || added.length === 0) return [...pairs];

  const byId = new Map<string, FileVersion[]>();
  const sizes = new Map<FileVersion, number>();
  for (const file of removed) {
    const ids = idsOf(file);
    sizes.set(file, ids.length);
    for (const id of ids) byId.set(id, [...(byId.get(id) ?? []), file]);
  }
  const found: { from: FileVersion; to: FileVersion; share: number }[] = [];
  for (const to of added) {
    const same = removed.find((from) => Buffer.compare(from.bytes, to.bytes) === 0);
    if (same !== undefined) found.push({ from: same, to, share: 2 });
    const ids = idsOf(to);
    const common = new Map<FileVersion, number>();
    for (const id of ids) for (const from of byId.get(id) ?? []) common.set(from, (common.get(from) ?? 0) + 1);
    for (const [from, count] of common) {
      const share = count / Math.max(ids.length, sizes.get(from) ?? 0);
      if (share >= LEAST_SHARE) found.push({ from, to, share });
    }
  }
  const used = new Set<FileVersion>();
  const renamed: Pair[] = [];
  for (const { from, to } of found.sort((p, q) => q.share - p.share)) {
    if (used.has(from) || used.has(to)) continue;
    used.add(from);
    used.add(to);
    renamed.push({ before: from, after: to });
  }
  const isUsed = ({ before, after }: Pair): boolean =>
    (before !== null && used.has(before)) || (after !== null && used.has(after));
  return [...pairs.filter((pair) => !isUsed(pair)), ...renamed];
}
