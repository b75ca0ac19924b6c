import { enablePatches, type Patch as ImmerPatch, applyPatches as immerApply } from 'immer';
import { commonEnds } from '../../../check/runs/index.ts';
import { isSame, type LevelFile } from '../../../schema/index.ts';

enablePatches();

/**
 * One difference between two level files. `path` leads from the root. In a list, `add` inserts before its index and `remove`
 * closes the gap, so patches must be applied in order.
 */
export interface Patch {
  readonly op: 'add' | 'remove' | 'replace';
  readonly path: readonly (string | number)[];
  readonly value?: unknown;
}

type Path = readonly (string | number)[];
type Json = { readonly [key: string]: unknown };

const isObject = (value: unknown): value is Json => typeof value === 'object' && value !== null && !Array.isArray(value);

/** What identifies an entry of a list at any index: the id of an object, the name of a run; holds have nothing. */
function nameOf(entry: unknown): string | null {
  if (!isObject(entry)) return null;
  if (typeof entry.id === 'string') return entry.id;
  return typeof entry.name === 'string' ? entry.name : null;
}

/** The names of all entries; null if one has none or two are equal. */
function namesOf(list: readonly unknown[]): string[] | null {
  const names: string[] = [];
  for (const entry of list) {
    const name = nameOf(entry);
    if (name === null) return null;
    names.push(name);
  }
  return new Set(names).size === names.length ? names : null;
}

function diffKeyed(before: readonly unknown[], after: readonly unknown[], path: Path, into: Patch[]): boolean {
  const old = namesOf(before);
  const now = namesOf(after);
  if (old === null || now === null) return false;
  const kept = new Set(now);
  const known = new Set(old);
  const survivors = old.filter((name) => kept.has(name));
  const inOrder = now.filter((name) => known.has(name)).every((name, i) => name === survivors[i]);
  if (!inOrder) return false;
  for (let i = old.length - 1; i >= 0; i--) if (!kept.has(old[i])) into.push({ op: 'remove', path: [...path, i] });
  for (let i = 0; i < now.length; i++) if (!known.has(now[i])) into.push({ op: 'add', path: [...path, i], value: after[i] });
  const from = new Map(old.map((name, i) => [name, i]));
  for (let i = 0; i < now.length; i++) {
    const index = from.get(now[i]);
    if (index !== undefined) diffValue(before[index], after[i], [...path, i], into);
  }
  return true;
}

function diffUnkeyed(before: readonly unknown[], after: readonly unknown[], path: Path, into: Patch[]): void {
  if (before.length === after.length) {
    for (let i = 0; i < after.length; i++) diffValue(before[i], after[i], [...path, i], into);
    return;
  }
  const { head, tail } = commonEnds(before, after, isSame);
  for (let i = before.length - tail - 1; i >= head; i--) into.push({ op: 'remove', path: [...path, i] });
  for (let i = head; i < after.length - tail; i++) into.push({ op: 'add', path: [...path, i], value: after[i] });
}

function diffLists(before: readonly unknown[], after: readonly unknown[], path: Path, into: Patch[]): void {
  const isHolds = (list: readonly unknown[]) => list.every((entry) => nameOf(entry) === null);
  if (isHolds(before) && isHolds(after)) diffUnkeyed(before, after, path, into);
  else if (!diffKeyed(before, after, path, into)) into.push({ op: 'replace', path, value: after });
}

function diffObjects(before: Json, after: Json, path: Path, into: Patch[]): void {
  for (const key of Object.keys(before)) if (!Object.hasOwn(after, key)) into.push({ op: 'remove', path: [...path, key] });
  for (const [key, value] of Object.entries(after)) {
    const inner = [...path, key];
    if (!Object.hasOwn(before, key)) into.push({ op: 'add', path: inner, value });
    // values under x- keys belong to other programs and are replaced as a whole
    else if (!key.startsWith('x-')) diffValue(before[key], value, inner, into);
    else if (!isSame(before[key], value)) into.push({ op: 'replace', path: inner, value });
  }
}

function diffValue(before: unknown, after: unknown, path: Path, into: Patch[]): void {
  if (before === after) return;
  if (Array.isArray(before) && Array.isArray(after)) diffLists(before, after, path, into);
  else if (isObject(before) && isObject(after)) diffObjects(before, after, path, into);
  else into.push({ op: 'replace', path, value: after });
}

/**
 * The patches from one file to another. Shared parts are skipped, so a change in one place costs next to nothing. Objects are
 * matched by id and runs by name: deleting one of a thousand is one patch.
 */
export function diffFiles(before: LevelFile, after: LevelFile): Patch[] {
  const patches: Patch[] = [];
  diffValue(before, after, [], patches);
  return patches;
}

/** Applies patches in order. @throws if they don't fit the file */
export const applyPatches = (file: LevelFile, patches: readonly Patch[]): LevelFile =>
  immerApply(file, patches as readonly ImmerPatch[] as ImmerPatch[]);
