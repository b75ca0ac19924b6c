import { type Circle, type Level, rulesOf } from '../schema/basics/index.ts';
import { type Accuracy, type AccuracyName, DEFAULT_ACCURACY, validAccuracy } from './accuracy.ts';
import { boxOf } from './contact.ts';
import { ALL_EFFECTS, type EffectSet, explosionsAtStart, strongestOf } from './effects/index.ts';
import { circlesOf, type IndexedCircles, indexed } from './indexed-circles.ts';
import type { Scene } from './scene.ts';
import { type Terms, termsOf } from './terms.ts';

/**
 * Prepares a level for simulation under some terms: chooses the effects that the level calls for and lays its objects out in
 * typed arrays.
 *
 * @param level - a level that `readLevel` or `resolveLevel` gave; the engine trusts its numbers to be finite and
 * its radii to be positive
 * @param under - the terms under which the level is simulated; or only the name of an accuracy, or a custom setting from
 * {@link accuracyOf}, with {@link DEFAULT_TERMS} for the rest; {@link DEFAULT_ACCURACY} when left out
 * @throws {RangeError} when the accuracy is none, or a custom setting contradicts itself
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
export function compile(level: Level, under: AccuracyName | Accuracy | Terms = DEFAULT_ACCURACY): Scene {
  return compileWith(ALL_EFFECTS, level, termsOf(under));
}

/** The places in a list of all circles, without those that equal an earlier one. */
function unlike(list: readonly Circle[]): number[] {
  const kept: number[] = [];
  if (list.length === 0) return kept;
  const seen = new Set<string>();
  for (const [i, { x, y, radius }] of list.entries()) {
    const circle = `${x} ${y} ${radius}`;
    if (!seen.has(circle)) kept.push(i);
    seen.add(circle);
  }
  return kept;
}

/** Prepares a level for simulation with the effects that a program includes; see {@link compile}. */
export function compileWith(included: EffectSet, level: Level, terms: Terms): Scene {
  const { indexing } = included;
  const rules = rulesOf(level);
  const effects = included.choose(level);
  const parts = included.of(effects);
  const cold: number[] = [];
  const hot: number[] = [];
  for (let i = 0; i < level.asteroids.length; i++) (level.asteroids[i].hot ? hot : cold).push(i);
  const own: Record<string, unknown> = {};
  for (const { name, prepare } of parts) if (prepare !== undefined) own[name] = prepare(level, indexing);
  const prepared = {
    level,
    rules,
    box: boxOf(rules),
    effects,
    strongest: strongestOf(parts, level, rules),
    targets: indexed(circlesOf(level.asteroids, [...cold, ...hot]), indexing),
    coldCount: cold.length,
    novae: indexed(circlesOf(level.novae), indexing),
    repulsors: indexed(circlesOf(level.repulsors, unlike(level.repulsors)), indexing),
    aliens: indexed(circlesOf(level.aliens), indexing),
    minerals: indexed(circlesOf(level.minerals), indexing),
    own,
  };
  return sceneUnder(prepared, terms);
}

/**
 * The scene of the same level at another accuracy. It shares what does not depend on the accuracy, so it takes less time than
 * to compile the level again.
 *
 * @param scene - the scene
 * @param accuracy - the accuracy
 * @returns the scene that {@link compile} would make
 * @throws {RangeError} when the accuracy is none
 */
export const atAccuracy = (scene: Scene, accuracy: Accuracy): Scene =>
  accuracy === scene.accuracy ? scene : sceneUnder(scene, { ...scene.terms, accuracy: validAccuracy(accuracy) });

/** What is the same at all accuracies. */
type Prepared = Omit<Scene, 'accuracy' | 'terms' | 'aliens'> & { readonly aliens: IndexedCircles };

function sceneUnder(prepared: Prepared, terms: Terms): Scene {
  const { accuracy } = terms;
  const { level, rules, box, effects, strongest, targets, coldCount, novae, repulsors, aliens, minerals, own } = prepared;
  const { count, x, y, r, index, spatial } = aliens;
  // continuous time has places relative to where she starts
  const isRelative = accuracy.integrator !== 'arcade';
  const { astronaut } = level;
  const explosions = explosionsAtStart(aliens, isRelative ? astronaut.x : 0, isRelative ? astronaut.y : 0);
  // written out: spreads would give every scene a hidden class of its own, which slows property access down in V8
  return {
    level,
    rules,
    box,
    accuracy,
    terms,
    effects,
    strongest,
    targets,
    coldCount,
    novae,
    repulsors,
    aliens: { count, x, y, r, index, spatial, explosions },
    minerals,
    own,
  };
}
