import type { Level } from '../schema/basics/index.ts';
import { type Accuracy, type AccuracyName, DEFAULT_ACCURACY } from './accuracy.ts';
import { compileWith } from './compile-with.ts';
import { ALL_EFFECTS } from './effects/index.ts';
import type { Scene } from './scene.ts';
import { validAccuracy } from './valid-accuracy.ts';

/**
 * Prepares a level for simulation at one accuracy: chooses the effects that the level calls for and lays its objects out in
 * typed arrays.
 *
 * @param level - a level that `readLevel` or `resolveLevel` gave; the engine trusts its numbers to be finite and
 * its radii to be positive
 * @param accuracy - the name of an accuracy, or a custom setting from {@link accuracyOf}; {@link DEFAULT_ACCURACY} when left
 * out
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
export function compile(level: Level, accuracy: AccuracyName | Accuracy = DEFAULT_ACCURACY): Scene {
  return compileWith(ALL_EFFECTS, level, validAccuracy(accuracy));
}
