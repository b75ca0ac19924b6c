import type { Mark } from '../../picture/comparison/index.ts';
import {
  KINDS,
  kindOfList,
  type Level,
  type LevelFile,
  OBJECT_LISTS,
  type ObjectKind,
  type ObjectList,
  SINGLE_KINDS,
} from '../../schema/index.ts';
import { canonicalNotes } from '../notes.ts';
import { type Change, type FieldChange, followingKeys, isEqual, type Json, type KeyOrder, ownKeys, swapped } from './change.ts';
import { type Identity, matchEntries } from './match-entries.ts';

/** Keys of the level whose values are looked up by name. */
const MAPS: readonly string[] = ['rules', 'allow'];

/** The lists of a level whose entries are followed, in the order of a file. */
export const LISTS: readonly (Identity & { readonly list: string })[] = [
  ...OBJECT_LISTS.map((list) => ({ list, nameKey: 'id', place: KINDS[kindOfList(list)].places[0] })),
  { list: 'runs', nameKey: 'name', place: null },
];

const isMap = (value: unknown): value is Json => typeof value === 'object' && value !== null && !Array.isArray(value);

/** Whether two lists of notes have the same canonical text, which is sorted. */
const sameNotes = (before: unknown, after: unknown): boolean =>
  Array.isArray(before) && Array.isArray(after) && isEqual(canonicalNotes(before), canonicalNotes(after));

/** The fields that differ between two objects. */
function fieldsBetween(before: Json, after: Json): { readonly fields: FieldChange[]; readonly keys: KeyOrder | null } {
  const fields: FieldChange[] = [];
  for (const key of new Set([...Object.keys(before), ...Object.keys(after)])) {
    const [old, now] = [before[key], after[key]];
    if (isEqual(old, now) || (key === 'notes' && sameNotes(old, now))) continue;
    fields.push({ key, ...(old !== undefined && { before: old }), ...(now !== undefined && { after: now }) });
  }
  return { fields, keys: orderOfKeys(ownKeys(before), ownKeys(after), fields) };
}

/** The order of x- keys if it does not follow from the fields in both directions. */
function orderOfKeys(before: readonly string[], after: readonly string[], fields: readonly FieldChange[]): KeyOrder | null {
  if (before.length + after.length === 0) return null;
  const follows = isEqual(followingKeys(before, fields), after) && isEqual(followingKeys(after, fields.map(swapped)), before);
  return follows ? null : { before, after };
}

/**
 * Lists what changed between two versions of a level. Objects are followed by id and runs by name; those without are matched by
 * their content, then by the nearest place among objects of their kind. The list is empty if and only if both versions have
 * the same canonical text, and {@link applyDiff} makes the second version from the first.
 * @param before the content of a valid file
 * @param after likewise
 * @returns the changes, in the order of a file
 */
export function diffLevels(before: LevelFile, after: LevelFile): Change[] {
  const [b, a] = [before, after] as unknown as [Json, Json];
  const lists = new Set(LISTS.map(({ list }) => list));
  const changes: Change[] = [];
  const values: FieldChange[] = [];
  for (const key of new Set([...Object.keys(b), ...Object.keys(a)])) {
    if (lists.has(key)) continue;
    const [old, now] = [b[key], a[key]];
    if (isEqual(old, now)) continue;
    const isSingle = SINGLE_KINDS.some((kind) => kind === key);
    if (isSingle) {
      const between = fieldsBetween(old as Json, now as Json);
      changes.push({ type: 'changed', of: key, before: 0, after: 0, matchedBy: 'id', ...between });
    } else if (MAPS.includes(key) && isMap(old ?? {}) && isMap(now ?? {})) {
      const isEmpty = (value: unknown): boolean => isMap(value) && Object.keys(value).length === 0;
      const between = fieldsBetween((old ?? {}) as Json, (now ?? {}) as Json);
      changes.push({ type: 'map', of: key, ...between, empty: { before: isEmpty(old), after: isEmpty(now) } });
    } else {
      values.push({ key, ...(old !== undefined && { before: old }), ...(now !== undefined && { after: now }) });
    }
  }
  for (const list of LISTS)
    changes.push(...diffList(list, b[list.list] as Json[] | undefined, a[list.list] as Json[] | undefined));
  const keys = orderOfKeys(ownKeys(b), ownKeys(a), values);
  const ordered = keys === null ? [] : [{ type: 'keys' as const, ...keys }];
  return [...values.map((value) => ({ type: 'value' as const, ...value })), ...changes, ...ordered];
}

function diffList(
  identity: Identity & { readonly list: string },
  writtenBefore: readonly Json[] | undefined,
  writtenAfter: readonly Json[] | undefined,
): Change[] {
  const { list: of } = identity;
  const [before, after] = [writtenBefore ?? [], writtenAfter ?? []];
  const changes: Change[] = [];
  const matches = matchEntries(before, after, identity);
  const [kept, come] = [new Set(matches.map((m) => m.before)), new Set(matches.map((m) => m.after))];
  for (const [index, entry] of before.entries()) if (!kept.has(index)) changes.push({ type: 'removed', of, index, entry });
  for (const { before: b, after: a, by } of matches) {
    if (before[b] === after[a]) continue;
    const { fields, keys } = fieldsBetween(before[b], after[a]);
    if (fields.length === 0 && keys === null) continue;
    changes.push({ type: 'changed', of, before: b, after: a, matchedBy: by, fields, keys });
  }
  for (const [index, entry] of after.entries()) if (!come.has(index)) changes.push({ type: 'added', of, index, entry });
  if (matches.some((match, i) => i > 0 && match.before < matches[i - 1].before)) {
    changes.push({ type: 'order', of, pairs: matches.map((match) => [match.before, match.after] as const) });
  }
  const isEmpty = (list: readonly Json[] | undefined): boolean => list !== undefined && list.length === 0;
  if (isEmpty(writtenBefore) !== isEmpty(writtenAfter)) {
    changes.push({ type: 'empty-list', of, before: isEmpty(writtenBefore), after: isEmpty(writtenAfter) });
  }
  return changes;
}

/**
 * The objects that differ in what can be seen, for a picture of both versions.
 * @param changes what `diffLevels` found between the two
 */
export function marksOf(changes: readonly Change[], before: Level, after: Level): Mark[] {
  return changes.flatMap((change): Mark[] => {
    if (change.type !== 'added' && change.type !== 'removed' && change.type !== 'changed') return [];
    const kind = kindOf(change.of);
    if (kind === null) return [];
    const [b, a] = [before, after].map((level, side) => {
      if (change.type !== 'changed')
        return (change.type === 'added') === (side === 1) ? objectAt(level, kind, change.index) : null;
      return objectAt(level, kind, side === 0 ? change.before : change.after);
    });
    const isSeen = change.type !== 'changed' || change.fields.some(({ key }) => Object.hasOwn(KINDS[kind].fields, key));
    return isSeen ? [{ kind, before: b, after: a }] : [];
  });
}

const kindOf = (of: string): ObjectKind | null =>
  SINGLE_KINDS.find((kind) => kind === of) ?? (of === 'runs' ? null : kindOfList(of as ObjectList));

function objectAt(level: Level, kind: ObjectKind, index: number): NonNullable<Mark['before']> {
  const single = SINGLE_KINDS.find((one) => one === kind);
  return single === undefined ? level[KINDS[kind].list as ObjectList][index] : level[single];
}
