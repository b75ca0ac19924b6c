import { DEFAULT_TERMS, type Terms } from '../../../engine/index.ts';
import type { OwnRules } from '../../../schema/basics/index.ts';
import { PLACED_KINDS, type PlacedList } from './placed.ts';

/** How hard a generated level should be: a word, or a grade from 1 to 10 that is met within 0.5. */
export type WantedDifficulty = 'easy' | 'medium' | 'hard' | number;

/** How large a generated level should be: a word, or a size in px. The words mean 520 x 420, 800 x 600 and 1280 x 800 px. */
export type WantedSize =
  | 'small'
  | 'medium'
  | 'large'
  | {
      /** Width, 360 to 4000 px. */
      readonly width: number;
      /** Height, 360 to 4000 px. */
      readonly height: number;
    };

/**
 * What a generated level may contain besides cold asteroids, novae and minerals: hot asteroids (`hot`), a list of objects, or
 * `recoil`.
 */
export type Ingredient = 'hot' | 'recoil' | PlacedList;

const listsThatAre = (isUsual: boolean): readonly PlacedList[] =>
  PLACED_KINDS.filter((kind) => kind.isUsual === isUsual).map(({ list }) => list);

/** Every ingredient that a generated level may contain. */
export const INGREDIENTS: readonly Ingredient[] = ['hot', ...listsThatAre(true), 'recoil', ...listsThatAre(false)];

/** The ingredients that are used by default. An addition to this list changes the levels of all seeds. */
export const USUAL_INGREDIENTS: readonly Ingredient[] = ['hot', ...listsThatAre(true)];

/** What {@link createGenerator} should make. */
export interface GeneratorOptions {
  /** Any finite number. The same seed and options give the same level. */
  readonly seed: number;
  /** Size of the level; `medium` by default. */
  readonly size?: WantedSize;
  /** How hard the level should be; `medium` by default. */
  readonly difficulty?: WantedDifficulty;
  /** What the level may contain; {@link USUAL_INGREDIENTS} by default. */
  readonly ingredients?: readonly Ingredient[];
  /** Rules of the level; by default the game's own. */
  readonly rules?: OwnRules;
  /**
   * The terms under which both runs of the level have to hold, besides the accuracies `precise` and `arcade`, which are always asked
   * for; {@link DEFAULT_TERMS} by default. Their rules are not looked at.
   */
  readonly terms?: Terms;
  /** What the level is composed around; by default nothing in particular. */
  readonly theme?: ThemeName;
  /** The symmetry of the novae of a level with a theme; by default the theme's own. */
  readonly symmetry?: SymmetryKind;
  /** Whether a level with a theme has a mineral that leads elsewhere than the solution. By default only `lures` has. */
  readonly tempting?: boolean;
}

/** What a level has to fulfil, derived from the options. Lengths are in px. */
export interface GeneratorSpec {
  readonly width: number;
  readonly height: number;
  /** The grade must lie in [least, most]. */
  readonly grade: readonly [least: number, most: number];
  /** The number of asteroids: least and most. */
  readonly asteroids: readonly [number, number];
  /** The number of presses of the intended run: least and most. More than 5 cannot be certified in reasonable time. */
  readonly presses: readonly [number, number];
  /** Novae to begin with. More are added while the level is too easy. */
  readonly novae: number;
  /** The tube around the intended run holds its variations with every edge shifted by up to this many ticks. */
  readonly tube: number;
  /** Room between her box at its widest and a nova beside the tube, px. */
  readonly room: number;
  /** The least certified ticks. */
  readonly certifiedTicks: number;
  /** The least success under timing noise of 40 ms. */
  readonly p40: number;
  /** The shortest and the longest press of the intended run, ticks. */
  readonly hold: readonly [number, number];
  /** The longest pause of the intended run, ticks: the longer the pause, the farther a small error leads. */
  readonly coast: number;
  /** The largest share of single presses that may win. */
  readonly onePress: number;
  readonly ingredients: readonly Ingredient[];
  /** Rules that differ from the game's own; they are written into the level. */
  readonly rules: OwnRules;
  /** Under which the runs have to hold. */
  readonly terms: Terms;
  readonly theme: ThemeName | null;
  /** The symmetry that was asked for; null leaves it to the theme. */
  readonly symmetry: SymmetryKind | null;
  /** Whether a mineral has to lead elsewhere than the solution. */
  readonly tempting: boolean;
}

const SIZES = { small: [520, 420], medium: [800, 600], large: [1280, 800] } as const;

const GRADES = { easy: [1.2, 3.4], medium: [3.5, 5.4], hard: [5.5, 9] } as const;

/** Least side of a generated level, px: a smaller one has no room for a swing. */
const LEAST_SIDE = 360;

/** Greatest side, px: the chain of asteroids has to span it. */
const GREATEST_SIDE = 4000;

/**
 * Derives what a level has to fulfil.
 * @throws RangeError if the size or the grade is out of range
 */
export function specOf(options: GeneratorOptions): GeneratorSpec {
  const { size = 'medium', difficulty = 'medium', ingredients, rules = {}, theme = null, symmetry = null } = options;
  const { terms = DEFAULT_TERMS } = options;
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
  // 0 at grade 1, 1 at grade 7 and above.
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
    hold: [20, 159],
    coast: Math.round(100 + 120 * hardness),
    onePress: 0.06 * (1 - hardness) + 0.002,
    ingredients: ingredients ?? USUAL_INGREDIENTS,
    rules,
    terms,
    theme,
    symmetry,
    tempting: options.tempting ?? theme === 'lures',
  };
}

/** What a generated level is composed around. */
export type ThemeName = 'orbits' | 'corridors' | 'slings' | 'lures' | 'fields';

/** The names of all themes. */
export const THEME_NAMES: readonly ThemeName[] = ['orbits', 'corridors', 'slings', 'lures', 'fields'];

/** Of what kind the symmetry of a level is: none, a mirror image, or the same after half a turn. */
export type SymmetryKind = 'none' | 'mirror' | 'rotate';

/** Every kind of symmetry. */
export const SYMMETRIES: readonly SymmetryKind[] = ['none', 'mirror', 'rotate'];
