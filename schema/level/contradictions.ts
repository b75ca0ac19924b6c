import { OBJECT_LISTS, type Path } from '../basics/index.ts';

/** What contradicts itself in a level, without words. */
export type Contradiction =
  /** An id, or the name of a run, that was there before: `first` is the path of the object or the run that has it. */
  | { readonly what: 'repeated'; readonly path: Path; readonly name: string; readonly first: Path }
  /** A hold that does not end after it begins. */
  | { readonly what: 'reversed'; readonly path: Path; readonly press: number; readonly release: number };

/**
 * Finds what the shape alone does not say: ids and names of runs are unique, and every hold ends after it begins. Accepts any
 * JSON value and skips what has the wrong shape.
 */
export function* contradictionsIn(level: unknown): Generator<Contradiction, void, undefined> {
  const owners = new Map<string, Path>();
  for (const list of OBJECT_LISTS) {
    const entries = listOf(keyOf(level, list));
    for (let i = 0; i < entries.length; i++) {
      const id = keyOf(entries[i], 'id');
      if (typeof id !== 'string') continue;
      const first = owners.get(id);
      if (first === undefined) owners.set(id, [list, i]);
      else yield { what: 'repeated', path: [list, i, 'id'], name: id, first };
    }
  }
  const runs = listOf(keyOf(level, 'runs'));
  const names = new Map<unknown, Path>();
  for (let r = 0; r < runs.length; r++) {
    const name = keyOf(runs[r], 'name');
    const first = names.get(name);
    if (first === undefined) names.set(name, ['runs', r]);
    // an empty name is none, which the shape says
    else if (typeof name === 'string' && name !== '') yield { what: 'repeated', path: ['runs', r, 'name'], name, first };
    const holds = listOf(keyOf(runs[r], 'holds'));
    for (let h = 0; h < holds.length; h++) {
      const hold = holds[h];
      if (!Array.isArray(hold) || hold.length !== 2) continue;
      const [press, release] = hold as unknown[];
      if (typeof press !== 'number' || typeof release !== 'number' || release > press) continue;
      yield { what: 'reversed', path: ['runs', r, 'holds', h], press, release };
    }
  }
}

const listOf = (value: unknown): readonly unknown[] => (Array.isArray(value) ? value : []);

const keyOf = (value: unknown, key: string): unknown =>
  typeof value === 'object' && value !== null && Object.hasOwn(value, key) ? (value as Record<string, unknown>)[key] : undefined;
