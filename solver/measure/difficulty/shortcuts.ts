import { compile, isAccuracyName, maxTicksOf, type Scene, simulate, TICK } from '../../../engine/index.ts';
import type { Hold, Level } from '../../../schema/basics/index.ts';
import { proveImpossible } from '../../prove/index.ts';
import { createSearch } from '../../search/explore/index.ts';
import { type Candidate, type Goal, verifyRun } from '../../verified-run.ts';
import { verifyProof } from '../../verify/index.ts';
import { countOnePress } from './luck.ts';

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
const ONE_PRESS_LENGTH = 1200;

/** Ticks to spend on avoiding an asteroid by default. */
const ASTEROID_EFFORT = 1_000_000;

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

/**
 * Whether the level can be completed without an asteroid that the given run uses:
 * - `avoidable`: a run of the unchanged level wins and never targets this asteroid
 * - `replaceable`: no such run was found, but the level wins with the asteroid removed
 * - `needed`: it is proved that the black hole cannot be reached without the asteroid
 * - `unknown`: neither a run nor a proof was found; most likely the asteroid is needed
 */
export type AsteroidUse = 'avoidable' | 'replaceable' | 'needed' | 'unknown';

/** The answer for one asteroid. */
export interface WithoutAsteroid {
  /** Index in the level's list of asteroids, from 0. */
  readonly asteroid: number;
  /** Whether the level can be completed without it. */
  readonly use: AsteroidUse;
  /**
   * The run that shows it: of the unchanged level when `avoidable`, of the level without the asteroid when `replaceable`, else
   * null.
   */
  readonly run: Candidate | null;
}

/** The asteroids that the gun targets in a run: indices in the level's list, ascending. */
function targetsOf(scene: Scene, holds: readonly Hold[], maxTicks: number): number[] {
  const { events } = simulate(scene, holds, { maxTime: maxTicks * TICK });
  const used = new Set<number>();
  for (const event of events) if (event.type === 'target') used.add(event.index);
  return [...used].sort((a, b) => a - b);
}

/**
 * Finds out for each asteroid that a run uses whether the level can be completed without it.
 * @param options `effort`: ticks to simulate for each of the two searches
 */
function findWithoutAsteroids(
  scene: Scene,
  holds: readonly Hold[],
  goal: Goal,
  options: { readonly effort: number; readonly seed: number; readonly maxTicks: number },
): WithoutAsteroid[] {
  const { effort, seed, maxTicks } = options;
  const intended = targetsOf(scene, holds, maxTicks);
  if (intended.length === 0) return [];
  // Runs of the unchanged level. Each may avoid one asteroid or another.
  const search = createSearch(scene, { goal, seed, maxTicks });
  search.advance(effort);
  const ways = search.solutions.map((run) => ({ run, targets: targetsOf(scene, run.holds, maxTicks) }));

  return intended.map((asteroid): WithoutAsteroid => {
    const way = ways.find(({ targets }) => !targets.includes(asteroid));
    if (way !== undefined) return { asteroid, use: 'avoidable', run: way.run };
    const reduced = compile(levelWithout(scene.level, asteroid), scene.terms);
    if (isProvedImpossible(reduced, maxTicks)) return { asteroid, use: 'needed', run: null };
    const other = createSearch(reduced, { goal, seed, maxTicks });
    other.advance(effort);
    for (const { holds } of other.solutions) {
      const inFull = verifyRun(scene, holds, goal, maxTicks);
      if (inFull === null || targetsOf(scene, holds, maxTicks).includes(asteroid)) continue;
      return { asteroid, use: 'avoidable', run: inFull };
    }
    const run = other.solutions[0];
    return run === undefined ? { asteroid, use: 'unknown', run: null } : { asteroid, use: 'replaceable', run };
  });
}

const levelWithout = (level: Level, asteroid: number): Level => ({
  ...level,
  asteroids: level.asteroids.filter((_, i) => i !== asteroid),
});

/** Whether there is a proof that the checker confirms, for the accuracy of the scene. There are no proofs for custom settings. */
function isProvedImpossible({ level, accuracy }: Scene, maxTicks: number): boolean {
  if (!isAccuracyName(accuracy.name)) return false;
  const proof = proveImpossible(level, { accuracy: accuracy.name, maxTime: maxTicks * TICK });
  return proof !== null && verifyProof(level, proof).ok;
}
