import { compile, joinHolds } from '../../../engine/index.ts';
import { type Hold, isSame, type LevelFile, OBJECT_LISTS, resolveLevel, SINGLE_KINDS } from '../../../schema/index.ts';
import { isWhole, type LiveProof } from '../../core/proof/index.ts';
import { replayed } from './replayed.ts';

/** A run that completed the level, as it was before a change. */
export interface Former {
  readonly name: string;
  /** sorted and joined */
  readonly holds: readonly Hold[];
  readonly tick: number;
  /** Ids of the minerals that it collected. */
  readonly minerals: readonly string[];
}

const idsOf = (file: LevelFile, minerals: readonly number[]): string[] =>
  minerals.flatMap((index) => file.minerals?.[index]?.id ?? []);

/** Where minerals with these ids stand in a level; those that it does not have are left out. */
export const indicesOf = (file: LevelFile, ids: readonly string[]): number[] =>
  (file.minerals ?? []).flatMap(({ id }, index) => (id !== undefined && ids.includes(id) ? [index] : []));

/** The shown run, if it completes the level; null if it does not or that is not known. */
export function formerOf(proof: LiveProof): Former | null {
  const { run, file } = proof;
  if (!isWhole(proof) || run.outcome !== 'completed' || run.name === null) return null;
  const minerals = run.minerals.map(({ index }) => index);
  return { name: run.name, holds: run.holds, tick: run.tick, minerals: idsOf(file, minerals) };
}

/** The runs of a level besides one that complete it. @param proof says how it is simulated */
export function othersOf(file: LevelFile, shown: string | null, { terms }: LiveProof): Former[] {
  const others = (file.runs ?? []).filter(({ name }) => name !== shown);
  if (others.length === 0) return [];
  const scene = compile(resolveLevel(file, terms.rules), terms);
  return others.flatMap(({ name, holds }) => {
    const joined = joinHolds(holds);
    const end = replayed(scene, joined);
    return end === null ? [] : [{ name, holds: joined, tick: end.tick, minerals: idsOf(file, end.minerals) }];
  });
}

/** Whether a run completes the level as it is now. */
export function completesNow({ scene, level }: LiveProof, name: string | null): boolean {
  const run = level.runs.find((one) => one.name === name);
  return run !== undefined && replayed(scene, joinHolds(run.holds)) !== null;
}

const isAlike = (a: unknown, b: unknown): boolean => a === b || isSame(a, b);

/** Whether two files of one level differ in nothing that a run could meet. */
export const isSameGame = (a: LevelFile, b: LevelFile): boolean =>
  a.range === b.range &&
  a.recoil === b.recoil &&
  isAlike(a.rules, b.rules) &&
  SINGLE_KINDS.every((kind) => isAlike(a[kind], b[kind])) &&
  OBJECT_LISTS.every((list) => isAlike(a[list], b[list]));
