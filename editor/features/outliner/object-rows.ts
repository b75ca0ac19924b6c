import { isSame, KINDS, type LevelFile, type ObjectKind } from '../../../schema/index.ts';
import {
  type FoundObject,
  groupsIn,
  type Marks,
  marksOf,
  nameOf,
  type ObjectKey,
  objectsOf,
  titled,
} from '../../core/document/index.ts';
import { groupRowKey } from '../../core/order/index.ts';
import type { TreeRow } from '../../core/tree/index.ts';

export interface ObjectRow extends TreeRow {
  readonly title: string;
  /** null for the row of a group */
  readonly kind: ObjectKind | null;
  /** The name of the group, for its row; else null. */
  readonly group: string | null;
  /** null for the row of a kind or a group */
  readonly found: FoundObject | null;
  /** The key of the object, or those of all objects in the folder. */
  readonly keys: readonly ObjectKey[];
  /** Of the object; whether all of a folder are locked or hidden. */
  readonly marks: Pick<Marks, 'isLocked' | 'isHidden'>;
}

type RowPosition = Pick<TreeRow, 'depth' | 'place' | 'siblings'>;

/** The rows last made: most objects are the same after a step of a drag. */
const made = new WeakMap<FoundObject, ObjectRow>();

function objectRow(found: FoundObject, at: RowPosition): ObjectRow {
  const before = made.get(found);
  if (before?.depth === at.depth && before.place === at.place && before.siblings === at.siblings) return before;
  const row = newRow(found, at);
  made.set(found, row);
  return row;
}

function newRow(found: FoundObject, at: RowPosition): ObjectRow {
  const { key, kind, list, object } = found;
  const marks = marksOf(found);
  const title = marks.name ?? nameOf(found);
  const label = `${title}${list === null ? '' : `, ${key}`}, at ${Math.round(object.x)}, ${Math.round(object.y)}`;
  return { ...at, key, label, expanded: null, list, title, kind, group: null, found, keys: [key], marks };
}

interface Folder {
  readonly key: string;
  readonly title: string;
  readonly kind: ObjectKind | null;
  readonly group: string | null;
  readonly members: readonly FoundObject[];
}

function folderRow({ key, title, kind, group, members }: Folder, isOpen: boolean, place: number, siblings: number): ObjectRow {
  const marks = members.map(marksOf);
  return {
    key,
    depth: 1,
    label: `${title}, ${members.length}`,
    expanded: isOpen,
    list: null,
    place,
    siblings,
    title,
    kind,
    group,
    found: null,
    keys: members.map((found) => found.key),
    marks: { isLocked: marks.every(({ isLocked }) => isLocked), isHidden: marks.every(({ isHidden }) => isHidden) },
  };
}

/**
 * The objects of a level as a tree: what exists once, the groups, then the others by kind.
 * @param folded keys of the folders whose objects are not shown
 */
export function objectRows(file: LevelFile, folded: ReadonlySet<string>): ObjectRow[] {
  const objects = objectsOf(file);
  const groups = groupsIn(file);
  const grouped = new Set([...groups.values()].flat());
  const others = [...objects.values()].filter(({ key }) => !grouped.has(key));
  const singles = others.filter(({ list }) => list === null);
  const kinds = [...new Set(others.filter(({ list }) => list !== null).map(({ kind }) => kind))];
  const folders: Folder[] = [
    ...[...groups].map(([group, keys]) => ({
      key: groupRowKey(group),
      title: group,
      kind: null,
      group,
      members: keys.flatMap((key) => objects.get(key) ?? []),
    })),
    ...kinds.map((kind) => ({
      key: `@kind ${kind}`,
      title: titled(KINDS[kind].many),
      kind,
      group: null,
      members: others.filter((found) => found.kind === kind && found.list !== null),
    })),
  ];
  const roots = singles.length + folders.length;
  const rows = singles.map((found, place) => objectRow(found, { depth: 1, place, siblings: roots }));
  for (const [i, folder] of folders.entries()) {
    const isOpen = !folded.has(folder.key);
    rows.push(folderRow(folder, isOpen, singles.length + i, roots));
    if (!isOpen) continue;
    // the place of an object is that in its list of the file, wherever it is shown
    for (const found of folder.members) {
      const siblings = found.list === null ? 1 : (file[found.list]?.length ?? 1);
      rows.push(objectRow(found, { depth: 2, place: found.index, siblings }));
    }
  }
  return rows;
}

/** Whether two rows show and do the same. The row of an object is made anew only when something of it has changed. */
export const isSameRow = (a: ObjectRow, b: ObjectRow): boolean =>
  a === b ||
  (a.found === null &&
    b.found === null &&
    a.key === b.key &&
    a.title === b.title &&
    a.expanded === b.expanded &&
    isSame(a.marks, b.marks) &&
    isSame(a.keys, b.keys));
