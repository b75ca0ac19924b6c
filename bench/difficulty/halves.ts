import { type Difficulty, measureDifficulty } from '../../solver/index.ts';
import { ANY, type MeasuredScene } from './levels.ts';

/** What two independent halves of the measure say about a level. */
export interface Halves {
  readonly name: string;
  readonly kind: MeasuredScene['kind'];
  readonly grades: readonly [number, number];
  /** Success of the best run under timing noise of 40 ms. */
  readonly best: readonly [number, number];
  /** The mean over all runs. */
  readonly mean: readonly [number, number];
  /** Pass rates of synthetic players at their first attempt. */
  readonly first: readonly [number, number];
}

/** Half of everything that `gq difficulty` spends on the measure by default. */
const HALF = { samples: 500, games: 1000, effort: 2_500_000, playerEffort: 1_000_000 } as const;

/** Shortcuts are not part of the measure. */
const NO_SHORTCUTS = { asteroidEffort: 0, onePressStride: 600 } as const;

/** Measures a level twice, each time with half of the effort and with a seed of its own; null where one half finds no run. */
export function measureHalves({ name, kind, scene }: MeasuredScene): Halves | null {
  const measure = (seed: number): Difficulty | null =>
    measureDifficulty(scene, null, { ...HALF, ...NO_SHORTCUTS, goal: ANY, seed });
  const [a, b] = [measure(101), measure(202)];
  if (a === null || b === null) return null;
  const both = (figure: (difficulty: Difficulty) => number): [number, number] => [figure(a), figure(b)];
  return {
    name,
    kind,
    grades: both(({ grade }) => grade.value),
    best: both(({ robustness }) => robustness.p40.p),
    mean: both(({ comparison }) => comparison.meanP40),
    first: both(({ forecast }) => forecast?.attempts[0].pass.p ?? 0),
  };
}
