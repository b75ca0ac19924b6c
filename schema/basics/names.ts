import {
  appearanceOfObject,
  KINDS,
  kindOfList,
  nameWhenTouched,
  OBJECT_LISTS,
  type ObjectKind,
  type ObjectList,
  SINGLE_KINDS,
} from './kinds.ts';
import type { Path } from './problem.ts';
import { quote } from './words.ts';

/** Words count from 1: index 0 of a list in a file is number 1 to people. */
const numbered = (words: string, index: number): string => `${words} ${index + 1}`;

/**
 * What to call an object of a level: `asteroid 4`, `black hole`.
 * @param kind what it is
 * @param index in the level's list of that kind, from 0
 * @param object as a file or a level has it; with it a hot asteroid is called one: `hot asteroid 4`
 */
export function objectName(kind: ObjectKind, index: number, object: object = {}): string {
  const { one } = appearanceOfObject(kind, object);
  return KINDS[kind].list === null ? one : numbered(one, index);
}

/**
 * What to call an object that ends a run when it is touched: `hot asteroid 4`, `the black hole`.
 * @param kind what it is
 * @param index in the level's list of that kind, from 0
 */
export const touchedName = (kind: ObjectKind, index: number): string =>
  KINDS[kind].list === null ? `the ${KINDS[kind].one}` : numbered(nameWhenTouched(kind), index);

/** What each list of a level file holds. */
const ONE_OF: Readonly<Record<string, string>> = {
  ...Object.fromEntries(OBJECT_LISTS.map((list) => [list, KINDS[kindOfList(list)].one])),
  runs: 'run',
  conflicts: 'conflict',
  holds: 'hold',
  notes: 'note',
};

/** The entries of a hold. */
const EDGES = ['press', 'release'];

/** A key of an object, in words; a key that is no plain word is quoted. */
function keyInWords(key: string, isFirst: boolean): string {
  if (!/^[\w$-]+$/.test(key)) return JSON.stringify(key);
  const single = isFirst ? SINGLE_KINDS.find((kind) => kind === key) : undefined;
  return single === undefined ? key : KINDS[single].one;
}

const keyOf = (value: unknown, key: string | number): unknown =>
  typeof value === 'object' && value !== null && Object.hasOwn(value, key)
    ? (value as Record<string | number, unknown>)[key]
    : null;

/** What to call a run of a level that may not be valid: by its name where no other run has it, else by its number. */
function runName(index: number, level: unknown): string {
  const runs = keyOf(level, 'runs');
  const name = keyOf(keyOf(runs, index), 'name');
  const isItsOwn = () => Array.isArray(runs) && runs.every((run, i) => i === index || keyOf(run, 'name') !== name);
  return typeof name === 'string' && name !== '' && isItsOwn() ? `run ${quote(name)}` : numbered('run', index);
}

/**
 * A path in words: `asteroids[3].radius` is `asteroid 4, radius`, and `runs[0].holds[2][1]` is `run 1, hold 3, release`.
 * '' for the root.
 * @param level what the path leads into; with it a run is called by its name: `run "solution", hold 3, release`
 */
export function toWords(path: Path, level?: unknown): string {
  const words: string[] = [];
  for (let i = 0; i < path.length; i++) {
    const step = path[i];
    const next = path[i + 1];
    if (typeof step === 'number') {
      words.push(path[i - 2] === 'holds' && step < EDGES.length ? EDGES[step] : numbered('entry', step));
    } else if (typeof next === 'number' && Object.hasOwn(ONE_OF, step)) {
      words.push(step === 'runs' ? runName(next, level) : numbered(ONE_OF[step], next));
      i++;
    } else {
      words.push(keyInWords(step, i === 0));
    }
  }
  return words.join(', ');
}

/**
 * What to call an entry of a list of objects: `asteroid 4`.
 * @param list the list's key in a level file
 * @param index in that list, from 0
 */
export const entryName = (list: ObjectList, index: number): string => objectName(kindOfList(list), index);
