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
 * Proves that no run reaches a goal, where that can be shown quickly. Proofs are made for the accuracies that have a name: of
 * a setting of one's own nothing is claimed. Nothing that the separate checker doesn't confirm is given.
 * @returns null when there is no proof; then there may still be no run
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

/** A mineral that no run can collect, and why. */
export interface LostMineral {
  /** in the level's list */
  readonly index: number;
  readonly proof: Proof;
}

/** Of more minerals than this it is not asked in one check whether they can be collected: each takes a moment. */
const MOST_MINERALS = 20;

/** The minerals of which a check tries to prove that nobody collects them: of those that no run does, the first few. */
export function mineralsToProve({ minerals }: Pick<Level, 'minerals'>, collected: Iterable<number>): number[] {
  const known = new Set(collected);
  return [...minerals.keys()].filter((index) => !known.has(index)).slice(0, MOST_MINERALS);
}

/** Those of some minerals of which it can quickly be proved that no run collects them; confirmed by the separate checker. */
export function proveMineralsLost(
  level: Level,
  accuracy: Accuracy,
  asked: readonly number[],
  maxTicks: number,
  budget: WorkBudget = new WorkBudget(),
): LostMineral[] {
  if (!isAccuracyName(accuracy.name) || asked.length === 0) return [];
  // minerals are in nobody's way: without the others the level is the same
  const only = { ...level, minerals: asked.map((index) => level.minerals[index]) };
  return proveMineralsUnreachable(only, { accuracy: accuracy.name, maxTime: maxTicks * TICK, budget }).flatMap((proof) => {
    if (proof.about.kind !== 'mineral' || !verifyProof(only, proof).ok) return [];
    const index = asked[proof.about.index];
    const named = { ...proof, about: { kind: 'mineral', index } as const };
    return [
      { index, proof: { ...named, reason: proof.reason.replaceAll(`minerals[${proof.about.index}]`, `minerals[${index}]`) } },
    ];
  });
}
