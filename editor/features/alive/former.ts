import {
  compile,
  createSimulation,
  joinHolds,
  maxTicksOf,
  playScript,
  type Scene,
  WorkBudget,
  WorkLimitReached,
} from '../../../engine/index.ts';
import { type Hold, isSame, type LevelFile, OBJECT_LISTS, resolveLevel, SINGLE_KINDS } from '../../../schema/index.ts';
import type { EditedLevel, StepMark } from '../../core/document/index.ts';
import { isWhole, type LiveProof, MOST_WORK, type ProofStore } from '../../core/proof/index.ts';

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

// runs that are played again

/** How a run that completes a level does so. */
interface Completion {
  readonly tick: number;
  /** Indices of the collected minerals. */
  readonly minerals: readonly number[];
}

/**
 * Plays a run from the start, with no more work than a frame has room for.
 * @param holds sorted and disjoint
 * @returns null if it does not complete the level, or takes too much work
 */
export function replayed(scene: Scene, holds: readonly Hold[]): Completion | null {
  try {
    const simulation = createSimulation(scene, new WorkBudget(MOST_WORK));
    playScript(simulation, holds, maxTicksOf(scene.terms));
    const { ending } = simulation;
    if (ending?.outcome !== 'completed') return null;
    const minerals = Array.from({ length: scene.minerals.count }, (_, i) => i).filter((i) => simulation.isCollected(i));
    return { tick: ending.tick, minerals };
  } catch (error) {
    if (error instanceof WorkLimitReached) return null;
    throw error;
  }
}

// holds that were put in place of others

/** The holds that were put in place of the author's within one step, by run. */
export interface ReplacedHolds {
  /** @param start the level before the step */
  note(start: LevelFile, run: string, holds: readonly Hold[]): void;
  /**
   * Puts back the runs of the author whose new holds do not complete the level any more: a step leaves a run as it was, or
   * completes the level with it. Runs that something else has changed since are left alone.
   * @returns the names of these runs
   */
  putBack(start: LevelFile, step: StepMark): string[];
}

const runIn = ({ runs }: LevelFile, name: string) => runs?.find((run) => run.name === name);

const inShort = (holds: readonly Hold[] = []): string => joinHolds(holds).join();

export function createReplacedHolds(document: EditedLevel, proof: ProofStore): ReplacedHolds {
  let of: LevelFile | null = null;
  const replaced = new Map<string, string>();
  const follow = (start: LevelFile) => {
    if (of !== start) replaced.clear();
    of = start;
  };
  const isLost = (name: string): boolean =>
    inShort(runIn(document.file(), name)?.holds) === replaced.get(name) && !completesNow(proof.proof(), name);
  return {
    note(start, run, holds) {
      follow(start);
      replaced.set(run, inShort(holds));
    },
    putBack(start, step) {
      follow(start);
      const lost = [...replaced.keys()].filter(isLost);
      for (const name of lost) {
        replaced.delete(name);
        // with its notes, which had followed the holds
        document.amend(step, (draft) => {
          const [own, i] = [runIn(start, name), draft.runs?.findIndex((run) => run.name === name) ?? -1];
          if (own !== undefined && draft.runs !== undefined && i >= 0) draft.runs[i] = own;
        });
      }
      return lost;
    },
  };
}
