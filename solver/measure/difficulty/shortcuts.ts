import { maxTicksOf, type Scene } from '../../../engine/index.ts';
import type { Hold } from '../../../schema/basics/index.ts';
import type { Goal } from '../../goal.ts';
import { type Candidate, verifyRun } from '../../verified-run.ts';
import { countOnePress } from './one-press.ts';
import { findWithoutAsteroids, type WithoutAsteroid } from './without-asteroid.ts';

/** What single presses achieve. */
export interface OnePress {
  /** Pairs of press and release that meet the goal. */
  readonly count: number;
  /** Pairs tried: every 0 <= press < release <= `length` at multiples of `stride`. */
  readonly tried: number;
  /** The last tick at which a press or release was tried. */
  readonly length: number;
  /** Ticks between the presses tried; 1 is exhaustive. */
  readonly stride: number;
  /** A run with a single press that wins and has room around it; null when none wins. */
  readonly example: Candidate | null;
}

/** Simple runs that complete the level, of which its designer should know. */
export interface Shortcuts {
  /** The run without any press, when it meets the goal; else null. */
  readonly withoutPressing: Candidate | null;
  /** What single presses achieve. */
  readonly onePress: OnePress;
  /** One entry for each asteroid that the given run uses; empty without a run. */
  readonly withoutAsteroid: readonly WithoutAsteroid[];
}

/** What {@link findShortcuts} looks for and what it may spend. */
export interface ShortcutOptions {
  /**
   * The intended run, [press, release) in ticks: its asteroids are questioned, and single presses are tried within its length.
   */
  readonly run?: readonly Hold[] | null;
  /** The last tick at which single presses are tried; by default the end of the run, or 1200 without a run. */
  readonly length?: number;
  /** Single presses are tried at multiples of this many ticks; by default 1, every tick. */
  readonly stride?: number;
  /** Ticks to spend on each asteroid; 1,000,000 by default, 0 skips this question. */
  readonly effort?: number;
  /** Seed of the searches; 0 by default. */
  readonly seed?: number;
  /** A run fails when it lasts longer than this, ticks; that of the scene by default. */
  readonly maxTicks?: number;
}

/** The last tick at which single presses are tried when no run tells how long the level is: 20 s. */
export const ONE_PRESS_LENGTH = 1200;

/** Ticks to spend on avoiding an asteroid by default. */
export const ASTEROID_EFFORT = 1_000_000;

const ANY: Goal = { minerals: 'any' };

/**
 * Looks for simple runs that the designer may not have intended: without pressing, with a single press, and without an asteroid
 * that the intended run uses. The first two are exhaustive (single presses at a stride of 1). The third is a search: what it
 * finds is certain, what it does not find may still exist.
 * @param scene the compiled level
 * @param goal what a run has to achieve; by default only the black hole
 * @param options the intended run, and what to spend
 * @returns the shortcuts that were found
 */
export function findShortcuts(scene: Scene, goal: Goal = ANY, options: ShortcutOptions = {}): Shortcuts {
  const { run = null, effort = ASTEROID_EFFORT, stride = 1, seed = 0, maxTicks = maxTicksOf(scene.terms) } = options;
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
