import type { LevelFile } from '../../schema/index.ts';
import { type Change, type EntryChange, type FieldChange, followingKeys, type Json, type KeyOrder, ownKeys } from './change.ts';
import { LISTS } from './diff-levels.ts';

/** An object with changed fields, its x- keys in their new order. */
function withFields(object: Json, fields: readonly FieldChange[], keys: KeyOrder | null): Json {
  const own = keys?.after ?? followingKeys(ownKeys(object), fields);
  const values = new Map(Object.entries(object));
  for (const field of fields) {
    if (Object.hasOwn(field, 'after')) values.set(field.key, field.after);
    else values.delete(field.key);
  }
  const known = [...values].filter(([key]) => !own.includes(key));
  return Object.fromEntries([...known, ...own.map((key) => [key, values.get(key)])]);
}

/**
 * Makes the second version of a level from the first.
 * @param before the first version
 * @param changes what {@link diffLevels} found between the two
 * @returns the second version: its canonical text is that of the second version
 * @throws {RangeError} if a change is about something that the level does not have
 */
export function applyDiff(before: LevelFile, changes: readonly Change[]): LevelFile {
  const result = new Map(Object.entries(before));
  const values = changes.filter((change) => change.type === 'value');
  for (const change of changes) {
    if (change.type === 'map') {
      const map = withFields((result.get(change.of) ?? {}) as Json, change.fields, change.keys);
      if (Object.keys(map).length > 0 || change.empty.after) result.set(change.of, map as never);
      else result.delete(change.of);
    } else if (change.type === 'changed' && !LISTS.some(({ list }) => list === change.of)) {
      result.set(change.of, withFields(result.get(change.of) as Json, change.fields, change.keys) as never);
    }
  }
  for (const { list } of LISTS) {
    const about = changes.filter((change) => 'of' in change && change.of === list);
    if (about.length === 0) continue;
    const entries = applyToList((before as unknown as Json)[list] as readonly Json[] | undefined, about);
    if (entries === undefined) result.delete(list);
    else result.set(list, entries as never);
  }
  const keys = changes.find((change) => change.type === 'keys') ?? null;
  return withFields(Object.fromEntries(result), values, keys) as unknown as LevelFile;
}

function applyToList(written: readonly Json[] | undefined, changes: readonly Change[]): Json[] | undefined {
  const entries = new Map((written ?? []).entries());
  const added: EntryChange[] = [];
  const old = (index: number): Json => {
    const entry = entries.get(index);
    if (entry === undefined) throw new RangeError(`the level has no entry ${index}`);
    return entry;
  };
  let order: number[] | null = null;
  let isEmptyWritten = written !== undefined && written.length === 0;
  for (const change of changes) {
    if (change.type === 'added') added.push(change);
    else if (change.type === 'changed') entries.set(change.before, withFields(old(change.before), change.fields, change.keys));
    else if (change.type === 'order') order = change.pairs.map(([before]) => before);
    else if (change.type === 'empty-list') isEmptyWritten = change.after;
  }
  for (const change of changes) if (change.type === 'removed' && old(change.index)) entries.delete(change.index);
  const kept = order === null ? [...entries.values()] : order.map(old);
  const result: Json[] = [];
  for (const { index, entry } of added.sort((p, q) => p.index - q.index)) {
    while (result.length < index && kept.length > 0) result.push(kept.shift()!);
    result.push(entry);
  }
  result.push(...kept);
  return result.length > 0 || isEmptyWritten ? result : undefined;
}
