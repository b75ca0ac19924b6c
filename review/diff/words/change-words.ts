import { compareHolds } from '../../../check/runs/index.ts';
import { plural } from '../../../check/words/index.ts';
import {
  appearanceOfObject,
  DEFAULT_RANGE,
  type Hold,
  KINDS,
  type LevelFile,
  LISTED_KINDS,
  listOf,
  type ObjectKind,
  objectName,
  RULES,
  type RuleName,
  type RunNote,
  SINGLE_KINDS,
} from '../../../schema/index.ts';
import { namedNotes } from '../../notes.ts';
import type { Change, EntryChange, FieldChange, Json, MapChange, PartChange, ValueChange } from '../change.ts';
import { indicesInWords, numbersApart, objectClauses, placeInWords, quoted, valueChangeInWords } from './values.ts';

/** From this many objects of a kind that changed alike, they are named together. */
const SEVERAL = 3;

/**
 * The changes of a level in words that a designer uses, a line for each object or group of objects: `asteroid 2 moved 12 px
 * right, radius 16 -> 20 px`. Objects have their numbers of the later version, those that were removed the ones they had.
 * @param changes what `diffLevels` found
 * @param after the later version
 */
export function changesInWords(changes: readonly Change[], after: LevelFile): string[] {
  const lines = changes.flatMap((change) => {
    if (change.type === 'value') return [levelValueInWords(change)];
    if (change.type === 'map') return mapInWords(change);
    return [];
  });
  for (const kind of SINGLE_KINDS) {
    for (const change of changes) {
      if (change.type === 'changed' && change.of === kind) lines.push(sentence(KINDS[kind].one, objectClauses(kind, change)));
    }
  }
  for (const kind of LISTED_KINDS) {
    const list = listOf(kind);
    lines.push(
      ...objectsInWords(
        kind,
        changes.filter((change) => 'of' in change && change.of === list),
        (after[list] ?? []) as readonly Json[],
      ),
    );
  }
  lines.push(...runsInWords(changes, after));
  if (changes.some(({ type }) => type === 'keys')) lines.push('x- keys of the level in another order');
  return lines;
}

/** A name and what is said of it: `asteroid 2 moved 12 px right, radius 16 -> 20 px`, `asteroid 2: radius 16 -> 20 px`. */
function sentence(name: string, clauses: readonly string[]): string {
  const isVerb = /^(?:moved|became|is) /.test(clauses[0]);
  return `${name}${isVerb ? ' ' : ': '}${clauses.join(', ')}`;
}

function levelValueInWords(change: ValueChange): string {
  const { key, before, after } = change;
  switch (key) {
    case 'name':
      return `renamed ${quoted(String(before))} -> ${quoted(String(after))}`;
    case 'description':
      return `description ${before === undefined ? 'added' : after === undefined ? 'removed' : 'changed'}`;
    case 'range':
      return defaulted(change, DEFAULT_RANGE, 'range', ' px');
    case 'recoil': {
      const [was, is] = [before ?? false, after ?? false];
      if (was === is) return `recoil: ${String(is)}, the default, is ${after === undefined ? 'no longer' : 'now'} written`;
      return is === true ? 'recoil turned on' : 'recoil turned off';
    }
    case 'conflicts':
      return conflictsInWords(change);
    default:
      return valueChangeInWords(change);
  }
}

/** Conflicts that a merge has left in the file. */
function conflictsInWords({ before, after }: FieldChange): string {
  const count = (value: unknown): number => (typeof value === 'object' && value !== null ? Object.keys(value).length : 0);
  const [was, is] = [count(before), count(after)];
  if (is === 0) return 'conflicts of a merge resolved';
  if (was === is) return 'unresolved conflicts of a merge changed';
  return was === 0
    ? `${is} unresolved ${is === 1 ? 'conflict' : 'conflicts'} of a merge`
    : `unresolved conflicts ${was} -> ${is}`;
}

/** A number that has a default where it is left out. */
function defaulted(change: FieldChange, usual: number, name: string, unit: string): string {
  const [b, a] = [(change.before ?? usual) as number, (change.after ?? usual) as number];
  if (a === b) return `${name} ${a}${unit}, the default, is ${Object.hasOwn(change, 'after') ? 'now' : 'no longer'} written`;
  const [old, now] = numbersApart(b, a);
  return `${name} ${old} -> ${now}${unit}`;
}

function mapInWords({ of, fields, keys, empty }: MapChange): string[] {
  const lines = fields.map((field) => {
    if (of === 'rules' && Object.hasOwn(RULES, field.key)) {
      const { default: usual, unit } = RULES[field.key as RuleName];
      // without a value of its own a level has that of its folder, which need not be the default
      if (!Object.hasOwn(field, 'before') || !Object.hasOwn(field, 'after')) {
        return `rule ${valueChangeInWords(field, field.key, ` ${unit}`)}`;
      }
      return `rule ${defaulted(field, usual, field.key, ` ${unit}`)}`;
    }
    return `${of}: ${valueChangeInWords(field)}`;
  });
  if (keys !== null) lines.push(`${of}: x- keys in another order`);
  if (lines.length === 0 || (fields.length === 0 && empty.before !== empty.after)) {
    lines.push(`${of}: empty, and ${empty.after ? 'now' : 'no longer'} written`);
  }
  return lines;
}

function objectsInWords(kind: ObjectKind, changes: readonly Change[], after: readonly Json[]): string[] {
  const lines: string[] = [];
  for (const type of ['removed', 'changed', 'added'] as const) {
    if (type === 'changed') {
      lines.push(
        ...changedInWords(
          kind,
          changes.filter((change) => change.type === 'changed'),
          after,
        ),
      );
      continue;
    }
    const groups = new Map<string, { index: number; entry: Json }[]>();
    for (const change of changes) {
      if (change.type !== type) continue;
      const { many } = appearanceOfObject(kind, change.entry);
      const group = groups.get(many);
      if (group === undefined) groups.set(many, [change]);
      else group.push(change);
    }
    for (const [many, entries] of groups) {
      const [{ index, entry }] = entries;
      lines.push(
        entries.length === 1
          ? `${objectName(kind, index, entry)} ${type}${placeInWords(kind, entry)}`
          : `${entries.length} ${many} ${type} (${indicesInWords(entries.map((e) => e.index))})`,
      );
    }
  }
  for (const change of changes) {
    if (change.type === 'order') lines.push(`${KINDS[kind].many} in another order`);
    if (change.type === 'empty-list' && !changes.some(isEntry)) {
      lines.push(`${change.of}: an empty list is ${change.after ? 'now' : 'no longer'} written`);
    }
  }
  return lines;
}

const isEntry = (change: Change): change is EntryChange => change.type === 'added' || change.type === 'removed';

const GUESSED = { id: '', content: 'same content', place: 'nearest place' } as const;

/** The object by which a changed one is named: one that became hot is called an asteroid, and not a hot one. */
const shownAs = (kind: ObjectKind, { fields, after: index }: PartChange, after: readonly Json[]): Json =>
  fields.some(({ key }) => key === KINDS[kind].variant?.flag) ? {} : after[index];

function changedInWords(kind: ObjectKind, changes: readonly PartChange[], after: readonly Json[]): string[] {
  const groups = new Map<string, { change: PartChange; clauses: string[] }[]>();
  for (const change of changes) {
    const clauses = objectClauses(kind, change);
    const guess = GUESSED[change.matchedBy];
    if (guess !== '') clauses[clauses.length - 1] += ` (matched by ${guess})`;
    const key = `${appearanceOfObject(kind, shownAs(kind, change, after)).many}\n${clauses.join('\n')}`;
    const group = groups.get(key);
    if (group === undefined) groups.set(key, [{ change, clauses }]);
    else group.push({ change, clauses });
  }
  return [...groups.values()].flatMap((group) => {
    const appearance = appearanceOfObject(kind, shownAs(kind, group[0].change, after));
    if (group.length >= SEVERAL) {
      const numbers = indicesInWords(group.map(({ change }) => change.after));
      return [sentence(`${appearance.many} ${numbers}`, group[0].clauses)];
    }
    return group.map(({ change, clauses }) => {
      const was = change.before === change.after ? '' : ` (was ${change.before + 1})`;
      return sentence(`${objectName(kind, change.after, shownAs(kind, change, after))}${was}`, clauses);
    });
  });
}

function runsInWords(changes: readonly Change[], after: LevelFile): string[] {
  const lines: string[] = [];
  for (const change of changes) {
    if (!('of' in change) || change.of !== 'runs') continue;
    if (change.type === 'added' || change.type === 'removed') {
      lines.push(`run ${quoted(String(change.entry.name))} ${change.type}`);
    } else if (change.type === 'changed') {
      const run = (after.runs ?? [])[change.after];
      const renamed = change.fields.find(({ key }) => key === 'name');
      const clauses = change.fields.flatMap((field) => {
        if (field.key === 'name') return [];
        if (field.key === 'holds') return holdsClauses(field.before as readonly Hold[], field.after as readonly Hold[]);
        if (field.key === 'notes') return notesClauses(field.before as NotesOrNone, field.after as NotesOrNone);
        return [valueChangeInWords(field)];
      });
      if (renamed !== undefined) lines.push(`run ${quoted(String(renamed.before))} renamed to ${quoted(run.name)}`);
      if (change.keys !== null) clauses.push('x- keys in another order');
      if (clauses.length > 0) lines.push(`run ${quoted(run.name)}: ${clauses.join(', ')}`);
    } else if (change.type === 'order') {
      const first = change.pairs.find(([, index]) => index === 0);
      const isNewFirst = first !== undefined && first[0] !== 0;
      lines.push(isNewFirst ? `run ${quoted((after.runs ?? [])[0].name)} is now the first` : 'runs in another order');
    } else if (change.type === 'empty-list' && !changes.some((other) => isEntry(other) && other.of === 'runs')) {
      lines.push(`runs: an empty list is ${change.after ? 'now' : 'no longer'} written`);
    }
  }
  return lines;
}

/** More moved edges than this are counted and not listed. */
const MOST_EDGES = 6;

/** The changes of holds in words: `press 2 is 4 ticks later`, `hold 3 added (130-188)`. */
function holdsClauses(before: readonly Hold[], after: readonly Hold[]): string[] {
  const { moved, removed, added } = compareHolds(before, after);
  const clauses: string[] = [];
  const by = moved.map((edge) => edge.after - edge.before);
  const isAll = moved.length === 2 * after.length && moved.length > 2 && removed.length + added.length === 0;
  if (isAll && by.every((ticks) => ticks === by[0])) clauses.push(`every press and release is ${shiftInWords(by[0])}`);
  else if (moved.length > MOST_EDGES) {
    const most = Math.max(...by.map(Math.abs));
    clauses.push(`${moved.length} presses and releases moved by up to ${plural(most, 'tick')}`);
  } else {
    for (const { edge, hold, before: b, after: a } of moved) clauses.push(`${edge} ${hold + 1} is ${shiftInWords(a - b)}`);
  }
  const list = (what: string, indices: readonly number[], holds: readonly Hold[]): void => {
    if (indices.length > MOST_EDGES) clauses.push(`${indices.length} holds ${what}`);
    else for (const i of indices) clauses.push(`hold ${i + 1} ${what} (${holds[i][0]}-${holds[i][1]})`);
  };
  list('removed', removed, before);
  list('added', added, after);
  return clauses;
}

const shiftInWords = (ticks: number): string => `${plural(Math.abs(ticks), 'tick')} ${ticks > 0 ? 'later' : 'earlier'}`;

/** The notes of a run, as its file has them. */
type NotesOrNone = readonly RunNote[] | undefined;

/** More changed notes than this are counted and not listed. */
const MOST = 6;

/** The changes of notes in words: `note "swing" added at tick 200`, `note "swing" moved from tick 200 to 210`. */
function notesClauses(before: NotesOrNone, after: NotesOrNone): string[] {
  const [old, now] = [namedNotes(before ?? []), namedNotes(after ?? [])];
  const removed = [...old].flatMap(([name, note]) => (now.has(name) ? [] : [note]));
  const added = [...now].flatMap(([name, note]) => (old.has(name) ? [] : [note]));
  const clauses: string[] = [];
  for (const note of removed) {
    const at = (tick: number) => `tick ${tick}`;
    const moved = added.findIndex(({ text, tick }) => text === note.text && tick !== note.tick);
    const other = moved >= 0 ? moved : added.findIndex(({ tick }) => tick === note.tick);
    const [to] = other >= 0 ? added.splice(other, 1) : [null];
    if (to === null) clauses.push(`note ${quoted(note.text)} removed from ${at(note.tick)}`);
    else if (to.tick !== note.tick) clauses.push(`note ${quoted(note.text)} moved from ${at(note.tick)} to ${to.tick}`);
    else if (to.text !== note.text) clauses.push(`note at ${at(note.tick)} now says ${quoted(to.text)}`);
    else clauses.push(`x- keys of the note ${quoted(note.text)} changed`);
  }
  for (const { tick, text } of added) clauses.push(`note ${quoted(text)} added at tick ${tick}`);
  if (clauses.length > MOST) return [`${clauses.length} notes changed`];
  if (clauses.length === 0) clauses.push(`an empty list of notes is ${after === undefined ? 'no longer' : 'now'} written`);
  return clauses;
}
