import type { LevelFile } from '../../../schema/index.ts';
import { ASTRONAUT, BLACK_HOLE, type FoundObject, type ObjectKey, type ObjectKind, objectsOf } from '../../document/index.ts';
import type { TreeRow } from '../tree/index.ts';

/** What kinds are called in the outline; the first is of one. */
const NAMES: Readonly<Record<ObjectKind, readonly [one: string, many: string]>> = {
  astronaut: ['Astronaut', 'Astronauts'],
  blackHole: ['Black hole', 'Black holes'],
  asteroid: ['Asteroid', 'Asteroids'],
  nova: ['Nova', 'Novae'],
  repulsor: ['Repulsor', 'Repulsors'],
  alien: ['Alien', 'Aliens'],
  mineral: ['Mineral', 'Minerals'],
};

export interface ObjectRow extends TreeRow {
  readonly title: string;
  readonly kind: ObjectKind;
  /** null: the row of a kind */
  readonly found: FoundObject | null;
  readonly isHot: boolean;
  /** Keys of the object, or of all of the kind. */
  readonly keys: readonly ObjectKey[];
}

const isHot = ({ object }: FoundObject): boolean => 'hot' in object && object.hot === true;

function objectRow(found: FoundObject, depth: number, place: number, siblings: number): ObjectRow {
  const { key, kind, list, object, index } = found;
  const hot = isHot(found);
  const name = hot ? 'Hot asteroid' : NAMES[kind][0];
  const title = list === null ? name : `${name} ${index + 1}`;
  const label = `${title}${list === null ? '' : `, ${key}`}, at ${Math.round(object.x)}, ${Math.round(object.y)}`;
  return { key, depth, label, expanded: null, list, place, siblings, title, kind, found, isHot: hot, keys: [key] };
}

/** The objects of a level by kind, as a tree. @param folded kinds whose objects are not shown */
export function objectRows(file: LevelFile, folded: ReadonlySet<ObjectKind>): ObjectRow[] {
  const objects = [...objectsOf(file).values()];
  const singles = objects.filter(({ key }) => key === ASTRONAUT || key === BLACK_HOLE);
  const kinds = [...new Set(objects.filter(({ list }) => list !== null).map(({ kind }) => kind))];
  const roots = singles.length + kinds.length;
  const rows = singles.map((found, place) => objectRow(found, 1, place, roots));
  for (const [i, kind] of kinds.entries()) {
    const members = objects.filter((found) => found.kind === kind && found.list !== null);
    const title = NAMES[kind][1];
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
      isHot: false,
      keys: members.map(({ key }) => key),
    });
    if (!folded.has(kind)) rows.push(...members.map((found) => objectRow(found, 2, found.index, members.length)));
  }
  return rows;
}
