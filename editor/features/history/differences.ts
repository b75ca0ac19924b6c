import { type Change, changesInWords, diffLevels } from '../../../review/index.ts';
import {
  KINDS,
  kindOfList,
  type LevelFile,
  type ObjectKind,
  type ObjectList,
  objectName,
  SINGLE_KINDS,
} from '../../../schema/index.ts';
import { titled } from '../../core/document/index.ts';

/** A difference that can be taken back alone. */
export interface DifferencePart {
  readonly key: string;
  readonly words: string;
  readonly change: Change;
}

/** What differs about one object, run or part of the level. */
export interface Difference {
  readonly key: string;
  /** What it is about; null where the words of its only part say so. */
  readonly title: string | null;
  readonly parts: readonly DifferencePart[];
}

const objectKindOf = (of: string): ObjectKind | null =>
  SINGLE_KINDS.find((kind) => kind === of) ?? (of === 'runs' ? null : kindOfList(of as ObjectList));

/** Which fields are taken back together: the places of an object, else each alone. */
function groupOf(kind: ObjectKind | null, key: string): string {
  return kind !== null && KINDS[kind].places.flat().includes(key) ? 'place' : key;
}

/** A change in parts, each about one property. */
function partsOf(change: Change): readonly (readonly [key: string, part: Change])[] {
  if (change.type !== 'changed' && change.type !== 'map') return [['', change]];
  const kind = change.type === 'map' ? null : objectKindOf(change.of);
  const groups = new Map<string, (typeof change.fields)[number][]>();
  for (const field of change.fields) {
    const group = groupOf(kind, field.key);
    groups.set(group, [...(groups.get(group) ?? []), field]);
  }
  // an order of x- keys makes sense with all fields only
  if (groups.size < 2 || change.keys !== null) return [['', change]];
  return [...groups].map(([group, fields]) => [group, { ...change, fields }]);
}

function titleOf(change: Change, after: LevelFile): string | null {
  if (change.type === 'map') return titled(change.of);
  if (change.type !== 'changed') return null;
  const kind = objectKindOf(change.of);
  if (kind === null) return `Run "${(after.runs ?? [])[change.after]?.name}"`;
  const single = SINGLE_KINDS.find((one) => one === kind);
  const object = single === undefined ? (after[change.of as ObjectList] ?? [])[change.after] : after[single];
  return titled(objectName(kind, change.after, object as never));
}

/** A key that stays the same as long as the change is about the same thing. */
function keyOf(change: Change): string {
  if (change.type === 'value') return `value ${change.key}`;
  if (!('of' in change)) return change.type;
  if (change.type === 'added' || change.type === 'removed') return `${change.type} ${change.of} ${change.index}`;
  return change.type === 'changed' ? `changed ${change.of} ${change.after}` : `${change.type} ${change.of}`;
}

/** What differs between two versions of a level, in the words of `gq diff`, for each object and run. */
export function differencesBetween(before: LevelFile, after: LevelFile): Difference[] {
  return diffLevels(before, after).map((change) => {
    const key = keyOf(change);
    const parts = partsOf(change).map(([group, part]) => ({
      key: `${key} ${group}`,
      words: titled(changesInWords([part], after).join('; ')) || 'Changed',
      change: part,
    }));
    return { key, title: parts.length > 1 ? titleOf(change, after) : null, parts };
  });
}
