import type { Level, Rules } from '../schema/basics/index.ts';
import type { Accuracy } from './accuracy.ts';
import type { Box } from './contact.ts';
import type { IndexedCircles } from './indexed-circles.ts';
import type { Terms } from './terms.ts';

/** The aliens as they are placed in the level. */
export interface Aliens extends IndexedCircles {
  /** Pairs of aliens that overlap at the start, two indices each, in the order in which they explode. */
  readonly explosions: Int32Array;
}

/** An effect of the game, and why a level calls for it or does not. */
export interface ChosenEffect {
  /** Name of the effect. */
  readonly name: string;
  /** Why, in words: `2 aliens`, `no minerals`. */
  readonly because: string;
}

/** Which effects are simulated in a scene and which are left out. */
export interface EffectChoice {
  /** The effects that the level calls for, in the order of {@link EFFECTS}. */
  readonly simulated: readonly ChosenEffect[];
  /** The effects that the level does not call for, in the same order. */
  readonly notCalledFor: readonly ChosenEffect[];
}

/**
 * A level prepared for simulation under some terms; {@link compile} makes it. It is never changed, so it may be shared freely.
 */
export interface Scene {
  /** The level it was made of. */
  readonly level: Level;
  /** The game's rules in this level: the level's own values, and the defaults for the others. */
  readonly rules: Rules;
  /** The astronaut's collision box. */
  readonly box: Box;
  /** Upper bound of her acceleration by all forces together, px/s². Every other bound is derived from it. */
  readonly strongest: number;
  /** How the scene is simulated: the accuracy of its terms. */
  readonly accuracy: Accuracy;
  /** Under which terms whatever is said about the scene holds. */
  readonly terms: Terms;
  /** Which effects are simulated, which are not, and why. */
  readonly effects: EffectChoice;
  /**
   * All asteroids: cold ones in the level's order, then hot ones. Between equally near targets the first in this order wins.
   */
  readonly targets: IndexedCircles;
  /** How many of `targets` are cold; these come first. */
  readonly coldCount: number;
  /** The novae, in the level's order. */
  readonly novae: IndexedCircles;
  /** The repulsors, without those that equal an earlier one: where fields overlap the first acts, so copies never act. */
  readonly repulsors: IndexedCircles;
  /** The aliens, in the level's order. */
  readonly aliens: Aliens;
  /** The minerals, in the level's order. */
  readonly minerals: IndexedCircles;
  /** What effects made of the level for their own use, by the effect's name. */
  readonly own: Readonly<Record<string, unknown>>;
}

/**
 * The lists of objects of a level by name: all its lists but the runs. The table of kinds names them too, but a small game does
 * not bundle it.
 */
export const objectLists = (level: Level): [name: string, objects: readonly unknown[]][] =>
  Object.entries(level).filter(([name, value]) => Array.isArray(value) && name !== 'runs');
