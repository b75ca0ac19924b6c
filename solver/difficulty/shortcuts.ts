import type { Scene } from '../../engine/index.ts';
import type { Hold } from '../../schema/index.ts';
import type { Goal } from '../goal.ts';
import { type Candidate, DEFAULT_MAX_TICKS, verifyRun } from '../verified-run.ts';
import { countOnePress } from './one-press.ts';
import { findWithoutAsteroids, type WithoutAsteroid } from './without-asteroid.ts';

/** What a single press can do. */
export interface OnePress {
  /** Pairs of press and release that meet the goal. */
  readonly count: number;
  /** Pairs tried: every 0 <= press < release <= `length` at multiples of `stride`. */
  readonly tried: number;
  /** Presses and releases were tried up to this tick. */
  readonly length: number;
  /** ticks; 1 is exhaustive */
  readonly stride: number;
  /** One that wins with room around it, or null. */
  readonly example: Candidate | null;
}

/** Ways of winning that a designer should know of. */
export interface Shortcuts {
  /** The run of somebody who never presses, when it meets the goal. */
  readonly withoutPressing: Candidate | null;
  readonly onePress: OnePress;
  /** One for each asteroid that the given run targets; empty without a run. */
  readonly withoutAsteroid: readonly WithoutAsteroid[];
}

export interface ShortcutOptions {
  /** The run as it is meant: its asteroids are asked about, and single presses are tried within its length. */
  readonly run?: readonly Hold[] | null;
  /** Single presses are tried up to this tick; when left out the run's length, or {@link ONE_PRESS_LENGTH} without a run. */
  readonly length?: number;
  /** Single presses are tried at multiples of so many ticks; 1, every tick, when left out. */
  readonly stride?: number;
  /** Ticks simulated for each asteroid asked about; {@link ASTEROID_EFFORT} when left out, 0 asks about none. */
  readonly effort?: number;
  readonly seed?: number;
  /** Ticks after which a run that goes on has failed. */
  readonly maxTicks?: number;
}

/** Single presses are tried up to this tick where no run says how long the level is: 20 s. */
export const ONE_PRESS_LENGTH = 1200;

/** Ticks simulated to find a way without an asteroid where nothing else is said. */
export const ASTEROID_EFFORT = 1_000_000;

const ANY: Goal = { minerals: 'any' };

/**
 * Looks for ways of winning that the designer may not have meant. Without pressing, and with one press at a stride of 1, is exhaustive;
 * without an asteroid is a search: what it finds is sure, what it doesn't find may still exist.
 */
export function findShortcuts(scene: Scene, goal: Goal = ANY, options: ShortcutOptions = {}): Shortcuts {
  const { run = null, effort = ASTEROID_EFFORT, stride = 1, seed = 0, maxTicks = DEFAULT_MAX_TICKS } = options;
  const played = run === null ? null : verifyRun(scene, run, goal, maxTicks);
  const length = Math.min(options.length ?? (played === null ? ONE_PRESS_LENGTH : played.tick + 1), maxTicks);
  const presses = countOnePress(scene, goal, length, maxTicks, stride);
  const example = presses.example === null ? null : verifyRun(scene, presses.example, goal, maxTicks);
  return {
    withoutPressing: verifyRun(scene, [], goal, maxTicks),
    onePress: { count: presses.count, tried: presses.tried, length, stride, example },
    withoutAsteroid: run === null || effort === 0 ? [] : findWithoutAsteroids(scene, run, goal, { effort, seed, maxTicks }),
  };
}
