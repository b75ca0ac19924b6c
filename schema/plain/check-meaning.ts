import type { LevelFile } from '../level.ts';
import type { JsonObject } from '../migrate.ts';
import { Failure, inWords } from './failure.ts';

/**
 * Checks what the shape alone does not say: ids and names of runs are unique, and every hold ends after it begins.
 * @param file - a file of the right shape
 * @throws {Failure} if one of these is not so
 */
export function checkMeaning(file: JsonObject): void {
  const ids = new Set<string>();
  const add = (known: Set<string>, name: string, path: readonly (string | number)[]): void => {
    if (known.has(name)) throw new Failure(`expected ${inWords(name)} once, found it twice`, path);
    known.add(name);
  };
  for (const [list, entries] of Object.entries(file)) {
    if (!Array.isArray(entries) || list.startsWith('x-')) continue;
    for (const [i, { id }] of entries.entries()) if (id !== undefined) add(ids, id, [list, i, 'id']);
  }
  const names = new Set<string>();
  for (const [r, { name, holds }] of ((file as LevelFile).runs ?? []).entries()) {
    add(names, name, ['runs', r, 'name']);
    for (const [h, [press, release]] of holds.entries()) {
      if (release > press) continue;
      throw new Failure(`expected a release after the press ${press}, found ${release}`, ['runs', r, 'holds', h]);
    }
  }
}
