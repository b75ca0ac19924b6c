import type { LevelFile } from '../../schema/index.ts';
import { applyDiff } from './apply-diff.ts';
import { type Change, type Json, swapped } from './change.ts';
import { LISTS } from './diff-levels.ts';
import { matchEntries } from './match-entries.ts';

/**
 * Takes some changes back and leaves the others. Entries that come back have their ids, and their places among the entries that
 * both versions have.
 * @param before the first version
 * @param after the second version
 * @param changes some of those that {@link diffLevels} found between the two, or parts of them with fewer fields
 * @returns the second version without these changes
 * @throws {RangeError} if a change is about something that the second version does not have
 */
export function takeBack(before: LevelFile, after: LevelFile, changes: readonly Change[]): LevelFile {
  const back = changes.map(reversed);
  const placed = LISTS.flatMap(({ list, ...identity }) => {
    const about = back.filter((change) => 'of' in change && change.of === list);
    if (about.length === 0) return [];
    const [old, now] = [before, after].map((level) => ((level as unknown as Json)[list] ?? []) as readonly Json[]);
    const matches = matchEntries(old, now, { ...identity });
    return inPlace(about, now.length, new Map(matches.map((match) => [match.before, match.after])));
  });
  const isListed = (change: Change): boolean => 'of' in change && LISTS.some(({ list }) => list === change.of);
  return applyDiff(after, [...back.filter((change) => !isListed(change)), ...placed]);
}

/** An entry of the list that is made: one of the second version, or one that comes back, by its index there. */
type Token = { readonly now: number } | { readonly back: number };

/**
 * Changes of a list with indices of the list that they make when no others are applied.
 * @param back leads from the second version to the first
 * @param count entries of the second version
 * @param common indices in the second version by those in the first
 */
function inPlace(back: readonly Change[], count: number, common: ReadonlyMap<number, number>): Change[] {
  const gone = new Set(back.flatMap((change) => (change.type === 'removed' ? [change.index] : [])));
  const order = back.find((change) => change.type === 'order');
  const kept = (
    order === undefined
      ? [...Array(count).keys()]
      : withAll(
          order.pairs.map(([now]) => now),
          count,
        )
  ).filter((index) => !gone.has(index));
  const tokens: Token[] = kept.map((now) => ({ now }));
  const placeOf = (old: number): number => {
    const now = common.get(old);
    return tokens.findIndex((token) => ('now' in token ? token.now === now : token.back === old));
  };
  const come = back.flatMap((change) => (change.type === 'added' ? [change.index] : [])).sort((p, q) => p - q);
  const last = Math.max(-1, ...come, ...common.keys());
  for (const index of come) {
    let at = -1;
    for (let i = index - 1; i >= 0 && at < 0; i--) at = placeOf(i);
    if (at >= 0) at++;
    for (let i = index + 1; i <= last && at < 0; i++) at = placeOf(i);
    tokens.splice(at < 0 ? tokens.length : at, 0, { back: index });
  }
  return back.map((change): Change => {
    if (change.type === 'order') return { ...change, pairs: kept.map((now, i) => [now, i] as const) };
    if (change.type !== 'added') return change;
    return { ...change, index: tokens.findIndex((token) => 'back' in token && token.back === change.index) };
  });
}

/** An order of all entries: those that it does not speak of come after the entry that they follow now. */
function withAll(order: readonly number[], count: number): number[] {
  const all = [...order];
  const known = new Set(order);
  for (let index = 0; index < count; index++) {
    if (known.has(index)) continue;
    const previous = index === 0 ? -1 : all.indexOf(index - 1);
    all.splice(previous + 1, 0, index);
  }
  return all;
}

const keysBack = <T extends { readonly before: unknown; readonly after: unknown }>(keys: T): T => ({
  ...keys,
  before: keys.after,
  after: keys.before,
});

/** The change in the other direction: what leads from the second version to the first. */
function reversed(change: Change): Change {
  switch (change.type) {
    case 'value':
      return { type: 'value', ...swapped(change) };
    case 'map': {
      const { of, fields, keys, empty } = change;
      return { type: 'map', of, fields: fields.map(swapped), keys: keys && keysBack(keys), empty: keysBack(empty) };
    }
    case 'added':
      return { ...change, type: 'removed' };
    case 'removed':
      return { ...change, type: 'added' };
    case 'changed': {
      const { fields, keys } = change;
      return { ...keysBack(change), fields: fields.map(swapped), keys: keys && keysBack(keys) };
    }
    case 'order': {
      const pairs = change.pairs.map(([before, after]) => [after, before] as const);
      return { ...change, pairs: pairs.sort((p, q) => p[1] - q[1]) };
    }
    case 'empty-list':
    case 'keys':
      return keysBack(change);
  }
}
