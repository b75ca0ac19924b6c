import { EFFECTS, type EffectWork, type Mode, type Work, WorkBudget, workByEffect } from '../../../engine/index.ts';
import type { Rules } from '../../../schema/index.ts';
import type { LiveProof } from '../../core/proof/index.ts';

export interface SimulatedEffect {
  readonly name: string;
  readonly because: string;
  readonly summary: string;
  /** What it costs in the shown run; null under arcade. */
  readonly work: EffectWork | null;
}

/** The effects that a level calls for, those it does not, and what its shown run costs. */
export interface Survey {
  /** equal for the same level and run */
  readonly key: string;
  readonly simulated: readonly SimulatedEffect[];
  readonly notCalledFor: readonly { readonly name: string; readonly because: string; readonly summary: string }[];
  readonly modes: readonly Mode[];
  readonly work: Work;
  /** s */
  readonly time: number;
  readonly runName: string | null;
}

const summaryOf = (name: string, rules: Rules): string => EFFECTS.find((effect) => effect.name === name)?.summary(rules) ?? '';

let count = 0;
const sceneNumbers = new WeakMap<object, number>();

/** A number for a scene, unique to it. */
function numberOf(scene: object): number {
  const number = sceneNumbers.get(scene) ?? ++count;
  sceneNumbers.set(scene, number);
  return number;
}

/** Surveys a level and its shown run. @returns null if the level takes too much work for that */
export function surveyOf({ scene, terms, run, full, limit }: LiveProof): Survey | null {
  if (limit !== null || full === null) return null;
  const { simulated, notCalledFor } = scene.effects;
  const costs = workByEffect(scene, run.holds, new WorkBudget(terms.maxWork));
  return {
    key: `${numberOf(scene)} ${run.holds.join()}`,
    simulated: simulated.map(({ name, because }) => ({
      name,
      because,
      summary: summaryOf(name, scene.rules),
      work: costs?.find((cost) => cost.name === name) ?? null,
    })),
    notCalledFor: notCalledFor.map(({ name, because }) => ({ name, because, summary: summaryOf(name, scene.rules) })),
    modes: full.modes,
    work: full.work,
    time: full.time,
    runName: run.name,
  };
}
