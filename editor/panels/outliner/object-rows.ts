import { KINDS, type LevelFile, type ObjectKind } from '../../../schema/index.ts';
import { type FoundObject, nameOf, type ObjectKey, objectsOf, titled } from '../../document/index.ts';
import type { TreeRow } from '../tree/index.ts';

export interface ObjectRow extends TreeRow {
  readonly title: string;
  readonly kind: ObjectKind;
  /** null for the row of a kind */
  readonly found: FoundObject | null;
  /** The key of the object, or those of all objects of the kind. */
  readonly keys: readonly ObjectKey[];
}

function objectRow(found: FoundObject, depth: number, place: number, siblings: number): ObjectRow {
  const { key, kind, list, object } = found;
  const title = nameOf(found);
  const label = `${title}${list === null ? '' : `, ${key}`}, at ${Math.round(object.x)}, ${Math.round(object.y)}`;
  return { key, depth, label, expanded: null, list, place, siblings, title, kind, found, keys: [key] };
}

/** The objects of a level by kind, as a tree. @param folded kinds whose objects are hidden */
export function objectRows(file: LevelFile, folded: ReadonlySet<ObjectKind>): ObjectRow[] {
  const objects = [...objectsOf(file).values()];
  const singles = objects.filter(({ list }) => list === null);
  const kinds = [...new Set(objects.filter(({ list }) => list !== null).map(({ kind }) => kind))];
  const roots = singles.length + kinds.length;
  const rows = singles.map((found, place) => objectRow(found, 1, place, roots));
  for (const [i, kind] of kinds.entries()) {
    const members = objects.filter((found) => found.kind === kind && found.list !== null);
    const title = titled(KINDS[kind].many);
    rows.push({
      key: `@kind ${kind}`,
      depth: 1,
      label: `${title}, ${members.length}`,
      expanded: !folded.has(kind),
      list: null,
      place: singles.length + i,
      siblings: roots,
      title,
      kind,
      found: null,
      keys: members.map(({ key }) => key),
    });
    if (!folded.has(kind)) rows.push(...members.map((found) => objectRow(found, 2, found.index, members.length)));
  }
  return rows;
}
