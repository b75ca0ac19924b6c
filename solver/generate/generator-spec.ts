import type { OwnRules } from '../../schema/index.ts';
import { PLACED_KINDS, type PlacedList } from './placed/index.ts';

/** How hard a generated level should be: in a word, or a grade from 1 to 10 that it should come within half a grade of. */
export type WantedDifficulty = 'easy' | 'medium' | 'hard' | number;

/** How large: in a word, or in px. */
export type WantedSize = 'small' | 'medium' | 'large' | { readonly width: number; readonly height: number };

/** Things a generated level may contain besides asteroids, novae and minerals. */
export type Ingredient = 'hot' | 'repulsors' | 'aliens' | 'recoil' | PlacedList;

export const INGREDIENTS: readonly Ingredient[] = [
  'hot',
  'repulsors',
  'aliens',
  'recoil',
  ...PLACED_KINDS.map(({ list }) => list),
];

/** What may be drawn where nothing is said: what is added to this list changes the levels of all seeds. */
export const USUAL_INGREDIENTS: readonly Ingredient[] = ['hot', 'repulsors', 'aliens'];

export interface GeneratorOptions {
  /** Any finite number: the same seed and options give the same level. */
  readonly seed: number;
  /** `medium` when left out. */
  readonly size?: WantedSize;
  /** `medium` when left out. */
  readonly difficulty?: WantedDifficulty;
  /** What may be drawn; {@link USUAL_INGREDIENTS} when left out. */
  readonly ingredients?: readonly Ingredient[];
  /** Rules under which it is played; the game's own when left out. */
  readonly rules?: OwnRules;
}

/** What a level has to be, worked out from the options. Lengths in px. */
export interface GeneratorSpec {
  readonly width: number;
  readonly height: number;
  /** the grade lies in [least, most] */
  readonly grade: readonly [least: number, most: number];
  /** asteroids: least and most */
  readonly asteroids: readonly [number, number];
  /** presses on the way the level is built around: least and most; more than 5 can't be certified in reasonable time */
  readonly presses: readonly [number, number];
  /** novae to begin with; more are added as long as the level is too easy */
  readonly novae: number;
  /** ticks by which every edge may be off on the ways that are kept free */
  readonly tube: number;
  /** px between her box at its widest and a nova beside those ways */
  readonly room: number;
  /** least certificate, ticks */
  readonly certifiedTicks: number;
  /** least P(40 ms) */
  readonly p40: number;
  /** P(40 ms) that the way the level is built around should have before there are novae */
  readonly routeP40: number;
  /** longest stretch without the gun on that way, ticks: the longer, the farther a small error leads */
  readonly coast: number;
  /** most single presses that win, as a share of all pairs of press and release */
  readonly onePress: number;
  readonly ingredients: readonly Ingredient[];
  /** rules that are not the game's own; they go into the level */
  readonly rules: OwnRules;
}

const SIZES = { small: [520, 420], medium: [800, 600], large: [1280, 800] } as const;

const GRADES = { easy: [1.2, 3.4], medium: [3.5, 5.4], hard: [5.5, 9] } as const;

/** Least side of a generated level, px: less holds no swing. */
export const LEAST_SIDE = 360;

/** Greatest side, px: the chain of asteroids has to span it. */
export const GREATEST_SIDE = 4000;

/**
 * @throws RangeError for a size or a grade that can't be
 */
export function specOf({ size = 'medium', difficulty = 'medium', ingredients, rules = {} }: GeneratorOptions): GeneratorSpec {
  const [width, height] = typeof size === 'string' ? SIZES[size] : [size.width, size.height];
  for (const [name, side] of Object.entries({ width, height })) {
    if (side >= LEAST_SIDE && side <= GREATEST_SIDE) continue;
    throw new RangeError(`${name}: expected ${LEAST_SIDE} to ${GREATEST_SIDE} px, found ${side}`);
  }
  if (typeof difficulty === 'number' && !(difficulty >= 1 && difficulty <= 10)) {
    throw new RangeError(`difficulty: expected a grade from 1 to 10, or easy, medium or hard, found ${difficulty}`);
  }
  const grade = typeof difficulty === 'number' ? ([difficulty - 0.5, difficulty + 0.5] as const) : GRADES[difficulty];
  const middle = (grade[0] + grade[1]) / 2;
  // 0 at grade 1, 1 at grade 7
  const hardness = Math.min(1, Math.max(0, (middle - 1) / 6));
  const room = Math.sqrt(width * height) / 600;
  const asteroids = 1.5 + 2.5 * room * (0.5 + hardness);
  return {
    width,
    height,
    grade,
    asteroids: [Math.max(2, Math.floor(asteroids * 0.75)), Math.max(2, Math.ceil(asteroids * 1.1))],
    presses: [Math.round(1 + 2.5 * hardness), Math.round(2.5 + 2.5 * hardness)],
    novae: Math.round((2 + 6 * hardness) * room * room),
    tube: Math.round(5 - 3 * hardness),
    room: Math.round(12 - 9 * hardness),
    certifiedTicks: hardness < 0.3 ? 2 : 1,
    p40: 0.9 - 0.6 * hardness,
    routeP40: 0.97 - 0.4 * hardness,
    coast: Math.round(100 + 120 * hardness),
    onePress: 0.06 * (1 - hardness) + 0.002,
    ingredients: ingredients ?? USUAL_INGREDIENTS,
    rules,
  };
}
