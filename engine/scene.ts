import type { Level, Rules } from '../schema/index.ts';
import type { Accuracy } from './accuracy.ts';
import type { Box } from './contact/index.ts';
import type { IndexedCircles } from './indexed-circles.ts';

/** The aliens as the level has them. */
export interface Aliens extends IndexedCircles {
  /** Pairs that overlap there, two indices each, in the order in which they explode. */
  readonly explosions: Int32Array;
}

/** An effect of the game, and why a level calls for it or doesn't. */
export interface ChosenEffect {
  readonly name: string;
  readonly because: string;
}

/** What of the game is simulated in a scene, and what is left out. */
export interface EffectChoice {
  readonly simulated: readonly ChosenEffect[];
  readonly notCalledFor: readonly ChosenEffect[];
}

/** A level made ready to simulate at one accuracy. Never written to after `compile`; share it freely. */
export interface Scene {
  readonly level: Level;
  /** The numbers of the game: the level's own, and the original's where it has none. */
  readonly rules: Rules;
  readonly box: Box;
  /** The most that anything can accelerate her, px/s2: the one bound that everybody reads. */
  readonly strongest: number;
  readonly accuracy: Accuracy;
  /** What the level calls for and what it doesn't, with the reason. */
  readonly effects: EffectChoice;
  /** Everything the gun can target: cold asteroids in level order, then hot ones (the order in which ties are broken). */
  readonly targets: IndexedCircles;
  /** The first so many of `targets` are cold. */
  readonly coldCount: number;
  readonly novae: IndexedCircles;
  /** The first of equal ones alone: where they overlap the first wins, so the others never act. */
  readonly repulsors: IndexedCircles;
  readonly aliens: Aliens;
  readonly minerals: IndexedCircles;
  /** What effects prepared for themselves, by their names. */
  readonly own: Readonly<Record<string, unknown>>;
}
