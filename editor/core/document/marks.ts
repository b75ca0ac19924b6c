import type { LevelFile, ObjectKind } from '../../../schema/index.ts';
import { type FoundObject, type ObjectKey, objectsOf } from './objects.ts';

/** What only the editor knows of an object: keys of the file that nothing else looks into. */
export interface Marks {
  /** 1 to 60 characters; null: none */
  readonly name: string | null;
  /** The canvas can neither select nor change it. */
  readonly isLocked: boolean;
  /** The canvas does not show it while the level is edited. It is simulated all the same. */
  readonly isHidden: boolean;
  /** The name of its group, 1 to 60 characters; null: none */
  readonly group: string | null;
}

export type Mark = keyof Marks;

/** The keys of the file. */
export const MARK_KEYS = {
  name: 'x-name',
  isLocked: 'x-locked',
  isHidden: 'x-hidden',
  group: 'x-group',
} as const satisfies Readonly<Record<Mark, string>>;

/** characters of a name, of an object or of a group */
export const LONGEST_NAME = 60;

type Marked = { readonly [key in (typeof MARK_KEYS)[Mark]]?: unknown };

const isText = (value: unknown): value is string =>
  typeof value === 'string' && value.trim() !== '' && value.length <= LONGEST_NAME;

const textOf = (value: unknown): string | null => (isText(value) ? value : null);

/** The astronaut is drawn with her run, so she is always shown. */
export const canBeHidden = (kind: ObjectKind): boolean => kind !== 'astronaut';

/** Written out, as it is asked for thousands of objects at each step of a drag. */
const hasNone = (object: Marked): boolean =>
  object[MARK_KEYS.name] === undefined &&
  object[MARK_KEYS.isLocked] === undefined &&
  object[MARK_KEYS.isHidden] === undefined &&
  object[MARK_KEYS.group] === undefined;

const NO_MARKS: Marks = { name: null, isLocked: false, isHidden: false, group: null };

/** The marks of an object. Values of another form belong to another program and count as absent. */
export function marksOf({ kind, object }: Pick<FoundObject, 'kind' | 'object'>): Marks {
  const marked = object as Marked;
  if (hasNone(marked)) return NO_MARKS;
  return {
    name: textOf(marked[MARK_KEYS.name]),
    isLocked: marked[MARK_KEYS.isLocked] === true,
    isHidden: marked[MARK_KEYS.isHidden] === true && canBeHidden(kind),
    group: textOf(marked[MARK_KEYS.group]),
  };
}

/** Whether the key of a mark has a value of another program, which must stay. */
export function isForeign(object: object, mark: Mark): boolean {
  const value = (object as Marked)[MARK_KEYS[mark]];
  if (value === undefined) return false;
  return mark === 'name' || mark === 'group' ? !isText(value) : value !== true;
}

/** The marks of all objects of a file, sorted out. */
interface SortedMarks {
  readonly locked: ReadonlySet<ObjectKey>;
  readonly hidden: ReadonlySet<ObjectKey>;
  readonly groups: ReadonlyMap<string, readonly ObjectKey[]>;
  readonly visible: ReadonlyMap<ObjectKey, FoundObject>;
  readonly grabbable: ReadonlyMap<ObjectKey, FoundObject>;
}

const known = new WeakMap<LevelFile, SortedMarks>();

/** Computed once per file. */
function sorted(file: LevelFile): SortedMarks {
  const made = known.get(file);
  if (made !== undefined) return made;
  const objects = objectsOf(file);
  const [locked, hidden] = [new Set<ObjectKey>(), new Set<ObjectKey>()];
  const groups = new Map<string, ObjectKey[]>();
  for (const [key, found] of objects) {
    const marks = marksOf(found);
    if (marks === NO_MARKS) continue;
    const { isLocked, isHidden, group } = marks;
    if (isLocked) locked.add(key);
    if (isHidden) hidden.add(key);
    if (group === null) continue;
    const members = groups.get(group);
    if (members === undefined) groups.set(group, [key]);
    else members.push(key);
  }
  // most levels have no marks
  const without = (...gone: readonly ReadonlySet<ObjectKey>[]) =>
    gone.every(({ size }) => size === 0) ? objects : new Map([...objects].filter(([key]) => !gone.some((keys) => keys.has(key))));
  const marks = { locked, hidden, groups, visible: without(hidden), grabbable: without(hidden, locked) };
  known.set(file, marks);
  return marks;
}

export const lockedIn = (file: LevelFile): ReadonlySet<ObjectKey> => sorted(file).locked;
export const hiddenIn = (file: LevelFile): ReadonlySet<ObjectKey> => sorted(file).hidden;
/** The members of each group, by its name. */
export const groupsIn = (file: LevelFile): ReadonlyMap<string, readonly ObjectKey[]> => sorted(file).groups;
/** The objects that the canvas shows while the level is edited. */
export const visibleIn = (file: LevelFile): ReadonlyMap<ObjectKey, FoundObject> => sorted(file).visible;
/** The objects that the canvas can select: neither locked nor hidden. */
export const grabbableIn = (file: LevelFile): ReadonlyMap<ObjectKey, FoundObject> => sorted(file).grabbable;

/** These objects without the locked ones, which the canvas must not change. */
export function unlocked(file: LevelFile, keys: readonly ObjectKey[]): readonly ObjectKey[] {
  const locked = lockedIn(file);
  return locked.size === 0 ? keys : keys.filter((key) => !locked.has(key));
}
