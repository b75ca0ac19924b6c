import { type Accuracy, isAccuracyName, TICK, WorkBudget } from '../engine/index.ts';
import type { Level } from '../schema/index.ts';
import {
  type Goal,
  mineralsNeeded,
  type Proof,
  proveImpossible,
  proveMineralsUnreachable,
  verifyProof,
} from '../solver/index.ts';

/**
 * Tries to prove quickly that no run reaches a goal. There are no proofs for custom settings, only for the named accuracies.
 * The checker has confirmed every proof that is returned.
 * @param level the level
 * @param accuracy the accuracy for which the proof has to hold
 * @param goal what a run would have to achieve
 * @param maxTicks the longest a run may last, ticks
 * @param budget limits the work of the provers
 * @returns a proof, or null when none was found; the goal may then still be out of reach
 */
export function proveGoalImpossible(
  level: Level,
  accuracy: Accuracy,
  goal: Goal,
  maxTicks: number,
  budget: WorkBudget = new WorkBudget(),
): Proof | null {
  if (!isAccuracyName(accuracy.name)) return null;
  const proof = proveImpossible(level, { accuracy: accuracy.name, maxTime: maxTicks * TICK, budget });
  if (proof !== null && verifyProof(level, proof).ok) return proof;
  const count = level.minerals.length;
  const needed = mineralsNeeded(goal, count);
  if (needed === 0) return null;
  const lost = proveMineralsLost(level, accuracy, [...level.minerals.keys()], maxTicks, budget);
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
 * @param level the level
 * @param accuracy the accuracy for which the proofs have to hold; a custom setting has no proofs
 * @param asked indices of the minerals in question
 * @param maxTicks the longest a run may last, ticks
 * @param budget limits the work of the provers
 * @returns the minerals with a proof, in the order of `asked`
 */
export function proveMineralsLost(
  level: Level,
  accuracy: Accuracy,
  asked: readonly number[],
  maxTicks: number,
  budget: WorkBudget = new WorkBudget(),
): LostMineral[] {
  if (!isAccuracyName(accuracy.name) || asked.length === 0) return [];
  const options = { accuracy: accuracy.name, maxTime: maxTicks * TICK, budget };
  return proveMineralsUnreachable(level, options, asked).flatMap((proof) =>
    proof.about.kind === 'mineral' && verifyProof(level, proof).ok ? [{ index: proof.about.index, proof }] : [],
  );
}
