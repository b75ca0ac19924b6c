import type { LevelFile } from '../../../../schema/index.ts';
import type { Recipe } from '../edited-level.ts';
import { freeGroupName } from '../groups.ts';
import { canBeHidden, groupsIn, isForeign, MARK_KEYS, type Mark, type Marks, marksOf } from '../marks.ts';
import { changeObjects, type FoundObject, type ObjectKey, type PlacedObject } from '../objects.ts';

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
