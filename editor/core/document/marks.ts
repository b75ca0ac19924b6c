import { type LevelFile, type ObjectKind, objectName } from '../../../schema/index.ts';
import { keptWith } from '../kept/index.ts';
import type { Recipe } from './edited-level.ts';
import { changeObjects, type FoundObject, type ObjectKey, objectsOf, type PlacedObject } from './objects.ts';

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
const canBeHidden = (kind: ObjectKind): boolean => kind !== 'astronaut';

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
function isForeign(object: object, mark: Mark): boolean {
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

/** Computed once per file. */
const sorted = keptWith((file: LevelFile): SortedMarks => {
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
  return { locked, hidden, groups, visible: without(hidden), grabbable: without(hidden, locked) };
});

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

/** The group of an object; null if it has none. */
export function groupOf(file: LevelFile, key: ObjectKey): string | null {
  const found = objectsOf(file).get(key);
  return found === undefined ? null : marksOf(found).group;
}

/**
 * The group that the user works inside of: the one to which all selected objects belong, while some of its members are not
 * selected; null: none. Inside a group, clicks select single members.
 */
export function enteredGroup(file: LevelFile, selected: readonly ObjectKey[]): string | null {
  if (selected.length === 0) return null;
  const group = groupOf(file, selected[0]);
  if (group === null || selected.some((key) => groupOf(file, key) !== group)) return null;
  return selected.length < grabbableMembers(file, group).length ? group : null;
}

const grabbableMembers = (file: LevelFile, group: string): readonly ObjectKey[] => {
  const grabbable = grabbableIn(file);
  return (groupsIn(file).get(group) ?? []).filter((key) => grabbable.has(key));
};

/**
 * What a click on an object selects: its whole group, or the object alone if it has none or the user works inside of it. Locked
 * and hidden members are left out.
 */
export function unitOf(file: LevelFile, key: ObjectKey, selected: readonly ObjectKey[]): readonly ObjectKey[] {
  const group = groupOf(file, key);
  if (group === null || group === enteredGroup(file, selected)) return [key];
  const members = grabbableMembers(file, group);
  return members.includes(key) ? members : [key];
}

/** These objects, and the other members of their groups. */
export function withGroups(file: LevelFile, keys: readonly ObjectKey[]): readonly ObjectKey[] {
  if (groupsIn(file).size === 0) return keys;
  return [...new Set(keys.flatMap((key) => unitOf(file, key, [])))];
}

/** A free name for a group: the wanted one, or one with the next number. @param taken names besides those of the file */
export function freeGroupName(file: LevelFile, wanted: string, taken: ReadonlySet<string> = new Set()): string {
  const groups = groupsIn(file);
  const isFree = (name: string) => !groups.has(name) && !taken.has(name);
  if (isFree(wanted)) return wanted;
  const stem = wanted.replace(/ \d+$/, '').slice(0, LONGEST_NAME - 6);
  let number = 2;
  while (!isFree(`${stem} ${number}`)) number++;
  return `${stem} ${number}`;
}

/** With a capital letter at the beginning: `Black hole`. */
export const titled = (words: string): string => `${words.charAt(0).toUpperCase()}${words.slice(1)}`;

/** `Hot asteroid 3`; the number is the position in its list, from 1. */
export const nameOf = ({ kind, index, object }: FoundObject): string => titled(objectName(kind, index, object));

/** The name that the user has given it, else what `nameOf` says. */
export const ownNameOf = (found: FoundObject): string => marksOf(found).name ?? nameOf(found);

type Json = Readonly<Record<string, unknown>>;

/** Whether a mark of an object can be set: another program's value stays, and the astronaut is never hidden. */
export const canBeMarked = ({ kind, object }: Pick<FoundObject, 'kind' | 'object'>, mark: Mark): boolean =>
  !isForeign(object, mark) && (mark !== 'isHidden' || canBeHidden(kind));

/** Sets a mark of objects; null, false or a text without letters removes it. Objects whose mark can't be set stay as they are. */
export function setMark<M extends Mark>(keys: Iterable<ObjectKey>, mark: M, value: Marks[M]): Recipe {
  const isGone = value === null || value === false || (typeof value === 'string' && value.trim() === '');
  return (draft) =>
    changeObjects(draft, keys, (object, _, kind) => {
      if (!canBeMarked({ kind, object }, mark)) return object;
      const { [MARK_KEYS[mark]]: _old, ...others } = object as unknown as Json;
      return (isGone ? others : { ...object, [MARK_KEYS[mark]]: value }) as unknown as PlacedObject;
    });
}

/** Gives a group another name. @param file the current level */
export const renameGroup = (file: LevelFile, group: string, name: string): Recipe =>
  setMark(groupsIn(file).get(group) ?? [], 'group', name);

/**
 * The marks of copies: they are neither locked nor hidden, and the copy of a whole group is a group of its own.
 * @param file the level that the copies are added to
 * @param isWhole whether all members of a group are copied; a copy of some of them stays in the group
 * @param taken names of groups that other copies have got; those of these copies are added
 */
export function marksOfCopies(
  file: LevelFile,
  isWhole: (group: string) => boolean,
  taken: Set<string> = new Set(),
): <T extends PlacedObject>(object: T) => T {
  const names = new Map<string, string>();
  const nameFor = (group: string): string => {
    const name = names.get(group) ?? freeGroupName(file, group, taken);
    names.set(group, name);
    taken.add(name);
    return name;
  };
  return (object) => {
    const copy = { ...object } as Record<string, unknown>;
    const { isLocked, isHidden, group } = marksOf({ kind: 'asteroid', object });
    if (isLocked) delete copy[MARK_KEYS.isLocked];
    if (isHidden) delete copy[MARK_KEYS.isHidden];
    if (group !== null && isWhole(group)) copy[MARK_KEYS.group] = nameFor(group);
    return copy as typeof object;
  };
}
