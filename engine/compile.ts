import { type Circle, type Level, rulesOf } from '../schema/index.ts';
import { ACCURACIES, type Accuracy, type AccuracyName, DEFAULT_ACCURACY } from './accuracy.ts';
import { boxOf } from './contact/index.ts';
import { chooseEffects, effectsOf, explosionsAtStart, strongestOf } from './effects/index.ts';
import { circlesOf, indexed } from './indexed-circles.ts';
import type { Scene } from './scene.ts';

/** The places in a list of all circles, without those that equal an earlier one. */
function unlike(list: readonly Circle[]): number[] {
  const seen = new Set<string>();
  const kept: number[] = [];
  for (const [i, { x, y, radius }] of list.entries()) {
    const circle = `${x} ${y} ${radius}`;
    if (!seen.has(circle)) kept.push(i);
    seen.add(circle);
  }
  return kept;
}

/**
 * Prepares a level for simulation at one accuracy: chooses the effects that the level calls for and lays its objects out in
 * typed arrays.
 *
 * @param level - a level that `readLevel` or `resolveLevel` gave; the engine trusts its numbers to be finite and
 * its radii to be positive
 * @param accuracy - the name of an accuracy, or a custom setting from {@link accuracyOf}; {@link DEFAULT_ACCURACY} when left
 * out
 * @returns the scene; it is never changed afterwards and may be shared by any number of simulations
 *
 * @example
 * ```ts
 * import { compile, simulate } from 'gravity-quest-toolkit';
 * import { readLevel } from 'gravity-quest-toolkit/schema';
 *
 * const reading = readLevel(text);
 * if (reading.ok) {
 *   const scene = compile(reading.level, 'precise');
 *   const run = simulate(scene, [[12, 96]]);
 * }
 * ```
 */
export function compile(level: Level, accuracy: AccuracyName | Accuracy = DEFAULT_ACCURACY): Scene {
  const rules = rulesOf(level);
  const effects = chooseEffects(level);
  const parts = effectsOf(effects);
  const all = (list: readonly Circle[]) => circlesOf(list, [...list.keys()]);
  const cold: number[] = [];
  const hot: number[] = [];
  for (const [i, a] of level.asteroids.entries()) (a.hot ? hot : cold).push(i);
  const aliens = indexed(all(level.aliens));
  const chosen = typeof accuracy === 'string' ? ACCURACIES[accuracy] : accuracy;
  // continuous time has places relative to where she starts
  const origin = chosen.integrator === 'arcade' ? { x: 0, y: 0 } : level.astronaut;
  const explosions = explosionsAtStart(aliens, origin.x, origin.y);
  return {
    level,
    rules,
    box: boxOf(rules),
    accuracy: chosen,
    effects,
    strongest: strongestOf(parts, level, rules),
    targets: indexed(circlesOf(level.asteroids, [...cold, ...hot])),
    coldCount: cold.length,
    novae: indexed(all(level.novae)),
    repulsors: indexed(circlesOf(level.repulsors, unlike(level.repulsors))),
    aliens: { ...aliens, explosions },
    minerals: indexed(all(level.minerals)),
    own: Object.fromEntries(parts.flatMap(({ name, prepare }) => (prepare === undefined ? [] : [[name, prepare(level)]]))),
  };
}
