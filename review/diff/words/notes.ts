import type { RunNote } from '../../../schema/index.ts';
import { namedNotes } from '../../notes.ts';
import { quoted } from './values.ts';

/** The notes of a run, as its file has them. */
export type NotesOrNone = readonly RunNote[] | undefined;

/** More changed notes than this are counted and not listed. */
const MOST = 6;

/** The changes of notes in words: `note "swing" added at tick 200`, `note "swing" moved from tick 200 to 210`. */
export function notesClauses(before: NotesOrNone, after: NotesOrNone): string[] {
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
