import type { LevelFile } from '../../../schema/index.ts';
import { type GeneratorOptions, THEME_NAMES, type ThemeName } from './generator-spec.ts';
import { distanceBetween, type Traits, traitsOf } from './variety.ts';

/** The theme of each level of a pack: one for all, or one after the other. */
export type PackTheme = ThemeName | 'mixed' | 'none';

/** What a pack of levels should be like. */
export interface PackOptions extends Omit<GeneratorOptions, 'difficulty' | 'theme'> {
  /** How many levels, at least 1. */
  readonly count: number;
  /** The theme of its levels; without any by default. */
  readonly theme?: PackTheme;
  /** The grades of the first and of the last level, from 1 to 10; those between rise evenly. 2 and 5.5 by default. */
  readonly grades?: readonly [first: number, last: number];
}

/**
 * What is tried for a level of a pack. Every level of every round has a seed of its own.
 * @param options the pack
 * @param index the level, from 0
 * @param round how many levels were rejected in its place
 * @returns options of a generator
 */
export function packLevel(
  { count, theme = 'none', grades = [2, 5.5], ...rest }: PackOptions,
  index: number,
  round: number,
): GeneratorOptions {
  const [first, last] = grades;
  const difficulty = count === 1 ? first : first + ((last - first) * index) / (count - 1);
  const named = theme === 'mixed' ? THEME_NAMES[index % THEME_NAMES.length] : theme;
  return {
    ...rest,
    seed: rest.seed + index + round * count,
    // a tenth of a grade is finer than any measurement of it
    difficulty: Math.round(10 * difficulty) / 10,
    ...(named !== 'none' && { theme: named }),
  };
}

/** The least distance between two levels of a pack, by the measure of {@link varietyOf}. */
export const LEAST_DISTANCE = 0.3;

/** Accepts the levels of a pack one by one. */
export interface PackJudge {
  /**
   * Accepts a level if it is not too close to an earlier one and has another name.
   * @param file a level with a run
   * @returns whether it was accepted
   */
  accepts(file: LevelFile): boolean;
}

/** Creates a judge that has not accepted anything yet. */
export function createPackJudge(): PackJudge {
  const accepted: Traits[] = [];
  const names = new Set<string>();
  return {
    accepts(file) {
      const traits = traitsOf(file);
      if (names.has(file.name) || accepted.some((other) => distanceBetween(other, traits) < LEAST_DISTANCE)) return false;
      accepted.push(traits);
      names.add(file.name);
      return true;
    },
  };
}
