import { type OwnRules, ownRules } from '../default-rules.ts';
import type { Level } from '../level-types.ts';
import { LEVEL_SHAPE } from './level-shape.ts';
import type { Shape } from './shape.ts';

type Values = Readonly<Record<string, unknown>>;

/** A value with what it leaves out filled in, and without keys that are not of its shape. */
function filled(value: unknown, { each, keys }: Shape): unknown {
  if (each !== undefined) return (value as unknown[]).map((entry) => filled(entry, each));
  // + 0 turns -0 into 0, as in resolve.ts
  if (keys === undefined) return typeof value === 'number' ? value + 0 : value;
  return filledKeys(value as Values, Object.entries(keys));
}

function filledKeys(object: Values, keys: readonly (readonly [string, Shape])[]): Record<string, unknown> {
  const whole: Record<string, unknown> = {};
  for (const [key, shape] of keys) {
    const value = Object.hasOwn(object, key) ? object[key] : shape.usual;
    if (value !== undefined) whole[key] = filled(value, shape);
  }
  return whole;
}

/** Keys of a file that a level does not have. */
const LEFT_OUT: readonly string[] = ['$schema', 'version', 'conflicts'];

/**
 * The level of a valid file, as `resolveLevel` gives it.
 * @param folder - rules of the level's folder
 */
export function resolveShape(file: Values, folder: OwnRules): Level {
  const keys = Object.entries(LEVEL_SHAPE.keys as NonNullable<Shape['keys']>);
  const level = filledKeys(
    file,
    keys.filter(([key]) => !LEFT_OUT.includes(key)),
  );
  // the order of keys is that of resolveLevel
  const { name, description, astronaut, blackHole, range, recoil, rules: _, allow, runs, ...lists } = level;
  return {
    ...{ name, description, astronaut, blackHole, range, recoil },
    ...ownRules((file.rules ?? {}) as OwnRules, folder),
    ...(Object.keys((file.allow ?? {}) as Values).some((code) => !code.startsWith('x-')) && { allow }),
    ...lists,
    // without notes, which change nothing in play
    runs: (runs as Level['runs']).map((run) => ({ name: run.name, holds: run.holds })),
  } as unknown as Level;
}
