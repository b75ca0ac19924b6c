import { isAccuracyName, type Scene, WorkBudget } from '../engine/index.ts';
import type { Level } from '../schema/index.ts';
import {
  type Goal,
  mineralsNeeded,
  type Proof,
  proveImpossible,
  proveMineralsUnreachable,
  verifyProof,
} from '../solver/index.ts';

/** A budget for the proofs about a level, beside that of its runs: half of the work that the level may cost. */
export const proofBudget = ({ terms }: Scene): WorkBudget => new WorkBudget(terms.maxWork / 2);

/** What a proof has to cover under the terms of a scene; null for a custom setting, which has no proofs. */
function proveOptions({ terms }: Scene, budget: WorkBudget) {
  const { name } = terms.accuracy;
  return isAccuracyName(name) ? { accuracy: name, maxTime: terms.maxTime, budget } : null;
}

/**
 * Tries to prove quickly that no run reaches a goal. There are no proofs for custom settings, only for the named accuracies.
 * The checker has confirmed every proof that is returned.
 * @param scene the compiled level; the proof has to hold under its terms
 * @param goal what a run would have to achieve
 * @param budget limits the work of the provers
 * @returns a proof, or null when none was found; the goal may then still be out of reach
 */
export function proveGoalImpossible(scene: Scene, goal: Goal, budget: WorkBudget = proofBudget(scene)): Proof | null {
  const options = proveOptions(scene, budget);
  if (options === null) return null;
  const { level } = scene;
  const proof = proveImpossible(level, options);
  if (proof !== null && verifyProof(level, proof).ok) return proof;
  const count = level.minerals.length;
  const needed = mineralsNeeded(goal, count);
  if (needed === 0) return null;
  const lost = proveMineralsLost(scene, [...level.minerals.keys()], budget);
  return count - lost.length < needed ? lost[0].proof : null;
}

/** A mineral that no run can collect. */
export interface LostMineral {
  /** Index in the level's list of minerals, from 0. */
  readonly index: number;
  /** The proof that nobody can collect it. */
  readonly proof: Proof;
}

/** One check tries to prove this for at most this many minerals, because each takes a moment. */
const MOST_MINERALS = 20;

/**
 * Selects the minerals for which a check looks for a proof.
 * @param level the level with its minerals
 * @param collected indices of the minerals that some run collects
 * @returns indices of minerals that no run collects, ascending, at most 20
 */
export function mineralsToProve({ minerals }: Pick<Level, 'minerals'>, collected: Iterable<number>): number[] {
  const known = new Set(collected);
  return [...minerals.keys()].filter((index) => !known.has(index)).slice(0, MOST_MINERALS);
}

/**
 * Tries to prove quickly of some minerals that no run can collect them. The checker has confirmed every proof that is returned.
 * @param scene the compiled level; the proofs have to hold under its terms
 * @param asked indices of the minerals in question
 * @param budget limits the work of the provers
 * @returns the minerals with a proof, in the order of `asked`
 */
export function proveMineralsLost(
  scene: Scene,
  asked: readonly number[],
  budget: WorkBudget = proofBudget(scene),
): LostMineral[] {
  const options = proveOptions(scene, budget);
  if (options === null || asked.length === 0) return [];
  const { level } = scene;
  return proveMineralsUnreachable(level, options, asked).flatMap((proof) =>
    proof.about.kind === 'mineral' && verifyProof(level, proof).ok ? [{ index: proof.about.index, proof }] : [],
  );
}
