import { compile, isAccuracyName, type Scene, simulate, TICK } from '../../../engine/index.ts';
import type { Hold, Level } from '../../../schema/basics/index.ts';
import type { Goal } from '../../goal.ts';
import { proveImpossible } from '../../prove/index.ts';
import { type Candidate, createSearch } from '../../search/explore/index.ts';
import { verifyRun } from '../../verified-run.ts';
import { verifyProof } from '../../verify/index.ts';

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
export function targetsOf(scene: Scene, holds: readonly Hold[], maxTicks: number): number[] {
  const { events } = simulate(scene, holds, { maxTime: maxTicks * TICK });
  const used = new Set<number>();
  for (const event of events) if (event.type === 'target') used.add(event.index);
  return [...used].sort((a, b) => a - b);
}

/**
 * Finds out for each asteroid that a run uses whether the level can be completed without it.
 * @param options `effort`: ticks to simulate for each of the two searches
 */
export function findWithoutAsteroids(
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
