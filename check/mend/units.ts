import {
  DEFAULT_RANGE,
  fieldsOf,
  KINDS,
  type LevelFile,
  LISTED_KINDS,
  listOf,
  type ObjectKind,
  type OwnRules,
  RULE_NAMES,
  resolveLevel,
  rulesOf,
  SINGLE_KINDS,
} from '../../schema/index.ts';

type Path = readonly (string | number)[];
type Json = Readonly<Record<string, unknown>>;

/** A number that a change of a level has changed. */
export interface ChangedNumber {
  /** The key of its field or rule. */
  readonly key: string;
  /** Where it stands in the changed file. */
  readonly path: Path;
  readonly now: number;
  readonly was: number;
  /** What the file had before: undefined where it left the number out. */
  readonly written: number | undefined;
}

/** What belongs together in a change, and can be taken back by itself. */
export type Unit =
  | {
      /** Numbers of one object have changed: its place, its radius... */
      readonly what: 'object';
      readonly kind: ObjectKind;
      /** Index in the changed level's list, from 0. */
      readonly index: number;
      readonly numbers: readonly ChangedNumber[];
    }
  | { readonly what: 'range' | 'rule'; readonly numbers: readonly [ChangedNumber] }
  | {
      /** A flag of an object or of the level was switched. */
      readonly what: 'flag';
      /** null: of the level */
      readonly kind: ObjectKind | null;
      readonly index: number;
      readonly key: string;
      readonly path: Path;
      /** undefined: the file left it out */
      readonly written: unknown;
    }
  | { readonly what: 'added'; readonly kind: ObjectKind; readonly index: number }
  | { readonly what: 'removed'; readonly kind: ObjectKind; readonly index: number; readonly object: object };

/** Whether a unit consists of numbers, so that a part of it can be taken back. */
export const isNumeric = (unit: Unit): unit is Extract<Unit, { numbers: unknown }> => 'numbers' in unit;

/**
 * What a change of a level consists of. Objects are matched by their ids; runs, texts and the order of objects are no part of it.
 * @param before the file before the change
 * @param after the file after it
 * @param folder rules of the folder
 */
export function unitsOf(before: LevelFile, after: LevelFile, folder: OwnRules): Unit[] {
  const units: Unit[] = [];
  for (const kind of SINGLE_KINDS) units.push(...changesOf(kind, 0, before[kind], after[kind], [kind]));
  for (const kind of LISTED_KINDS) {
    const list = listOf(kind);
    const [old, now] = [before[list] ?? [], after[list] ?? []];
    if (old === now) continue;
    for (const [index, object] of now.entries()) {
      const former = old.find(({ id }) => id === object.id);
      if (former === undefined) units.push({ what: 'added', kind, index });
      else units.push(...changesOf(kind, index, former, object, [list, index]));
    }
    const kept = new Set(now.map(({ id }) => id));
    for (const [index, object] of old.entries()) {
      if (!kept.has(object.id)) units.push({ what: 'removed', kind, index, object });
    }
  }
  const range = { key: 'range', path: ['range'], now: after.range ?? DEFAULT_RANGE, was: before.range ?? DEFAULT_RANGE };
  if (range.now !== range.was) units.push({ what: 'range', numbers: [{ ...range, written: before.range }] });
  if ((before.recoil ?? false) !== (after.recoil ?? false)) {
    units.push({ what: 'flag', kind: null, index: 0, key: 'recoil', path: ['recoil'], written: before.recoil });
  }
  const [old, now] = [before, after].map((file) => rulesOf(resolveLevel(file, folder)));
  for (const key of RULE_NAMES) {
    if (old[key] === now[key]) continue;
    const number = { key, path: ['rules', key], now: now[key], was: old[key], written: before.rules?.[key] };
    units.push({ what: 'rule', numbers: [number] });
  }
  return units;
}

function changesOf(kind: ObjectKind, index: number, old: object, now: object, path: Path): Unit[] {
  if (old === now) return [];
  const units: Unit[] = [];
  const numbers: ChangedNumber[] = [];
  for (const [key, field] of fieldsOf(kind)) {
    const written = (old as Json)[key];
    const [was, is] = [written ?? field.default, (now as Json)[key] ?? field.default];
    if (was === is) continue;
    if (field.type === 'number') {
      numbers.push({
        key,
        path: [...path, key],
        now: is as number,
        was: was as number,
        written: written as number | undefined,
      });
    } else units.push({ what: 'flag', kind, index, key, path: [...path, key], written });
  }
  if (numbers.length > 0) units.unshift({ what: 'object', kind, index, numbers });
  return units;
}

/** Whether only places of the object have changed. */
export const isMove = (unit: Unit): boolean =>
  unit.what === 'object' && unit.numbers.every(({ key }) => KINDS[unit.kind].places.flat().includes(key));
