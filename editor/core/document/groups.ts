import type { LevelFile } from '../../../schema/index.ts';
import { grabbableIn, groupsIn, LONGEST_NAME, marksOf } from './marks.ts';
import { type ObjectKey, objectsOf } from './objects.ts';

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
