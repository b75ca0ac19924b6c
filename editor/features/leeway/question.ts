import type { Terms } from '../../../engine/index.ts';
import { type Hold, KINDS, type Level, type LevelFile, OBJECT_LISTS, RULE_NAMES } from '../../../schema/index.ts';
import { type FoundObject, type ObjectKey, objectsOf, placesOf } from '../../core/document/index.ts';
import type { LiveProof } from '../../core/proof/index.ts';

/** A box of places, px of the level. */
export interface Seen {
  readonly left: number;
  readonly top: number;
  readonly right: number;
  readonly bottom: number;
}

/** What is asked of a level: where some of its objects may stand, moved alike. */
export interface Question {
  readonly file: LevelFile;
  readonly level: Level;
  readonly terms: Terms;
  /** null: the level has no run, she drifts */
  readonly run: string | null;
  readonly holds: readonly Hold[];
  readonly keys: readonly ObjectKey[];
  /** Index of the only place of the object that moves; null: all of them. */
  readonly only: number | null;
  /** The place that is put on the grid, px. */
  readonly lead: { readonly x: number; readonly y: number };
  /** px; null: nothing snaps to a grid */
  readonly grid: number | null;
  /** What is examined: places of the lead, px. */
  readonly seen: Seen;
}

/** The objects of a question. */
export const objectsAsked = ({ file, keys }: Pick<Question, 'file' | 'keys'>): FoundObject[] =>
  keys.flatMap((key) => objectsOf(file).get(key) ?? []);

/** Asks where the selection may stand; null if it is empty. */
export function questionOf(
  { file, level, terms, run }: LiveProof,
  keys: readonly ObjectKey[],
  { only, grid, seen }: Pick<Question, 'only' | 'grid' | 'seen'>,
): Question | null {
  const [first, ...others] = objectsAsked({ file, keys });
  if (first === undefined) return null;
  // a place of its own has only an object that is selected alone
  const place = others.length > 0 || placesOf(first).length === 1 ? null : only;
  const lead = placesOf(first)[place ?? 0];
  return {
    file,
    level,
    terms,
    run: run.name,
    holds: run.holds,
    keys,
    only: place,
    lead: { x: lead.x, y: lead.y },
    grid,
    seen,
  };
}

const isSameList = (a: readonly unknown[], b: readonly unknown[]): boolean =>
  a.length === b.length && a.every((one, i) => one === b[i]);

/** Whether the same rules apply: those of the level and of its folder. */
const isSameRules = (one: Level, other: Level): boolean => RULE_NAMES.every((name) => one.rules?.[name] === other.rules?.[name]);

/** Whether only the places of some objects differ, all by the same shift as far as they move. */
export function isOnlyMoved(
  { file: before, level: one, keys, only }: Pick<Question, 'file' | 'level' | 'keys' | 'only'>,
  { file: after, level: other }: Pick<LiveProof, 'file' | 'level'>,
): boolean {
  if (!isSameRules(one, other)) return false;
  if (before === after) return true;
  if (before.range !== after.range || before.recoil !== after.recoil) return false;
  const asked = new Set(keys);
  let shift: { readonly x: number; readonly y: number } | null = null;
  const isMoved = (was: FoundObject, is: FoundObject | undefined): boolean => {
    if (is === undefined || is.kind !== was.kind || is.index !== was.index) return false;
    if (!asked.has(was.key)) return is.object === was.object;
    const { fields, places } = KINDS[was.kind];
    const [then, now] = [was.object, is.object] as unknown as Readonly<Record<string, unknown>>[];
    const moving = places.filter((_, i) => only === null || i === only).flat();
    if (!Object.keys(fields).every((name) => moving.includes(name) || then[name] === now[name])) return false;
    const [from, to] = [placesOf(was), placesOf(is)];
    for (const [i, place] of to.entries()) {
      if (only !== null && i !== only) continue;
      const by = { x: place.x - from[i].x, y: place.y - from[i].y };
      shift ??= by;
      if (Math.abs(by.x - shift.x) > ROUNDING || Math.abs(by.y - shift.y) > ROUNDING) return false;
    }
    return true;
  };
  const now = objectsOf(after);
  if (!OBJECT_LISTS.every((list) => (before[list]?.length ?? 0) === (after[list]?.length ?? 0))) return false;
  for (const [key, was] of objectsOf(before)) if (!isMoved(was, now.get(key))) return false;
  return true;
}

/** px by which shifts may differ that are meant to be the same */
const ROUNDING = 1e-6;

/** Whether an answer to one question is one to the other. */
export const asksSame = (one: Question, other: Question): boolean =>
  one.terms === other.terms &&
  one.run === other.run &&
  one.grid === other.grid &&
  one.only === other.only &&
  isSameList(one.keys, other.keys) &&
  isSameRules(one.level, other.level) &&
  one.holds.join() === other.holds.join();

/** Whether a box contains another. */
export const contains = (outer: Seen, inner: Seen): boolean =>
  outer.left <= inner.left && outer.top <= inner.top && outer.right >= inner.right && outer.bottom >= inner.bottom;
