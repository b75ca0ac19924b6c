import { KINDS, type LevelFile, LIMITS, listOf, type ObjectKind } from '../../schema/index.ts';
import type { Steps } from '../../solver/index.ts';
import { type ChangedNumber, isMove, isNumeric, type Unit } from './units.ts';

/** A change of a level, or a part of it, taken back. */
export interface TakenBack {
  readonly units: readonly Unit[];
  /** How much of the change of their numbers is taken back: 1 is all. */
  readonly share: number;
  /** The file with it. */
  readonly file: LevelFile;
}

/** Shares that are tried first, from the smallest: so many, up to all. */
const GRID = 64;

/** Halvings between a share that is too small and one that is enough. */
const HALVINGS = 8;

/** Places and sizes are rounded to this part of a px, other numbers to this part of their unit. */
const PARTS = { px: 10, other: 100 } as const;

const PX = new Set(['radius', 'range']);

/** A number after a share of its change is taken back, as a designer would write it. */
export function valueAfter({ now, was, key }: ChangedNumber, share: number, isPlace: boolean): number {
  const parts = isPlace || PX.has(key) ? PARTS.px : PARTS.other;
  return Math.round((now + share * (was - now)) * parts) / parts;
}

type Json = Record<string | number, unknown>;

/** A copy of a value of a file that can be changed. */
function copied(value: unknown): unknown {
  if (Array.isArray(value)) return value.map(copied);
  if (typeof value !== 'object' || value === null) return value;
  return Object.fromEntries(Object.entries(value).map(([key, inner]) => [key, copied(inner)]));
}

function write(file: Json, path: readonly (string | number)[], value: unknown): void {
  const [key, ...rest] = path;
  if (rest.length > 0) {
    file[key] ??= {};
    write(file[key] as Json, rest, value);
    return;
  }
  if (value === undefined) delete file[key];
  else file[key] = value;
}

const isPlace = (unit: Unit, key: string): boolean => unit.what === 'object' && KINDS[unit.kind].places.flat().includes(key);

/** The file with a share of the units' numbers taken back, and with the other units taken back as a whole. */
export function takenBack(after: LevelFile, units: readonly Unit[], share: number): LevelFile {
  const file = copied(after) as Json;
  for (const unit of units) {
    if (unit.what === 'flag') write(file, unit.path, unit.written);
    if (!isNumeric(unit)) continue;
    for (const number of unit.numbers) {
      write(file, number.path, share === 1 ? number.written : valueAfter(number, share, isPlace(unit, number.key)));
    }
  }
  if (typeof file.rules === 'object' && file.rules !== null && Object.keys(file.rules).length === 0) delete file.rules;
  for (const unit of [...units].reverse()) if (unit.what === 'added') listIn(file, unit.kind).splice(unit.index, 1);
  for (const unit of units) {
    if (unit.what === 'removed') listIn(file, unit.kind).splice(unit.index, 0, copied(unit.object));
  }
  return file as unknown as LevelFile;
}

function listIn(file: Json, kind: ObjectKind): unknown[] {
  const list = listOf(kind as never) as string;
  file[list] ??= [];
  return file[list] as unknown[];
}

/**
 * Seeks the smallest part of a change that must be taken back so that a run completes the level: of each unit by itself, and of
 * all of them by the same share. Nothing says that a larger part is always enough where a smaller one is; a scan from the smallest
 * on finds the first that is, and bisection the least of it.
 * @param completes whether the run completes a file
 * @param tell called with each part that is enough
 */
export function* seekTakeBacks(
  after: LevelFile,
  units: readonly Unit[],
  completes: (file: LevelFile) => boolean,
  tell: (found: TakenBack) => void,
): Steps<void> {
  const sets = units.length > 1 && units.length <= MOST_UNITS ? [...units.map((unit) => [unit]), units] : [units];
  for (const set of sets) {
    const found = yield* smallest(after, set, completes);
    if (found !== null) tell(found);
  }
}

/** More units than this are taken back together only. */
const MOST_UNITS = 12;

function* smallest(after: LevelFile, units: readonly Unit[], completes: (file: LevelFile) => boolean): Steps<TakenBack | null> {
  const at = (share: number): TakenBack => ({ units, share, file: takenBack(after, units, share) });
  const works = (share: number) => completes(at(share).file);
  if (!units.some(isNumeric)) {
    yield null;
    return works(1) ? at(1) : null;
  }
  const steps = Math.max(1, Math.min(GRID, Math.ceil(lengthOf(units))));
  for (let i = 1; i <= steps; i++) {
    yield null;
    if (!works(i / steps)) continue;
    let [low, high] = [(i - 1) / steps, i / steps];
    for (let k = 0; k < HALVINGS; k++) {
      const middle = (low + high) / 2;
      yield null;
      if (works(middle)) high = middle;
      else low = middle;
    }
    return at(high);
  }
  return null;
}

/** How far units are moved at most, px; other numbers count as a grid of their own. */
function lengthOf(units: readonly Unit[]): number {
  const lengths = units.map((unit) => (isMove(unit) ? distanceOf(unit, 1) : isNumeric(unit) ? GRID : 0));
  return Math.min(LIMITS.coordinate, Math.max(...lengths));
}

/** How far a share of a move takes an object back, px; of several places the farthest. */
export function distanceOf(unit: Unit, share: number): number {
  if (unit.what !== 'object') return 0;
  const by = (key: string): number => {
    const number = unit.numbers.find((one) => one.key === key);
    if (number === undefined) return 0;
    return (share === 1 ? number.was : valueAfter(number, share, true)) - number.now;
  };
  return Math.max(...KINDS[unit.kind].places.map(([x, y]) => Math.sqrt(by(x) * by(x) + by(y) * by(y))));
}
