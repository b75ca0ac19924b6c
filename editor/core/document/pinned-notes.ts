import { type LevelFile, LIMITS } from '../../../schema/index.ts';
import { keptWith } from '../kept/index.ts';
import type { Recipe } from './edited-level.ts';

/** A note that is pinned to a place of the level, for those who edit it. */
export interface PinnedNote {
  readonly id: string;
  /** px */
  readonly x: number;
  readonly y: number;
  /** 1 to 500 characters */
  readonly text: string;
}

/** The key of the file: an object whose keys are the ids of the notes. */
const KEY = 'x-notes';
/** characters of a note */
export const LONGEST_PINNED_NOTE = 500;
/** notes that are shown at most */
const MOST = 200;

type Json = { readonly [key: string]: unknown };

const isObject = (value: unknown): value is Json => typeof value === 'object' && value !== null && !Array.isArray(value);

const isPlace = (value: unknown): value is number => typeof value === 'number' && Math.abs(value) <= LIMITS.coordinate;

function isNote(value: unknown): value is Omit<PinnedNote, 'id'> {
  if (!isObject(value) || !isPlace(value.x) || !isPlace(value.y)) return false;
  return typeof value.text === 'string' && value.text !== '' && value.text.length <= LONGEST_PINNED_NOTE;
}

const NONE: readonly PinnedNote[] = [];

const notesIn = keptWith((value: Json): readonly PinnedNote[] =>
  Object.entries(value)
    .flatMap(([id, note]) => (isNote(note) ? [{ id, x: note.x, y: note.y, text: note.text }] : []))
    .slice(0, MOST),
);

/** The notes of a level. What has another form belongs to another program and is left out. The same list for the same value. */
export function pinnedNotesIn(file: LevelFile): readonly PinnedNote[] {
  const value = (file as Json)[KEY];
  return isObject(value) ? notesIn(value) : NONE;
}

/** Why no note can be added; null: one can. */
export function pinProblem(file: LevelFile): string | null {
  const value = (file as Json)[KEY];
  if (value !== undefined && !isObject(value))
    return 'x-notes of this level has a value of another program, which stays as it is.';
  return pinnedNotesIn(file).length < MOST ? null : `A level shows ${MOST} notes at most: delete one first.`;
}

/** A free id that follows from the place, so that notes that are added on two branches rarely have the same one. */
function freeId(notes: Json, x: number, y: number): string {
  const part = (value: number) => Math.abs(Math.round(value)).toString(36);
  const stem = `n${part(x)}-${part(y)}`;
  let id = stem;
  for (let i = 2; Object.hasOwn(notes, id); i++) id = `${stem}-${i}`;
  return id;
}

const change =
  (make: (notes: Json) => Json): Recipe =>
  (draft) => {
    const file = draft as Record<string, unknown>;
    const value = file[KEY];
    if (value !== undefined && !isObject(value)) return;
    const notes = make({ ...value });
    if (Object.keys(notes).length === 0) delete file[KEY];
    else file[KEY] = notes;
  };

/** Adds a note; its id follows from its place. */
export const pinNote = (x: number, y: number, text: string): Recipe =>
  change((notes) => ({ ...notes, [freeId(notes, x, y)]: { x, y, text: text.slice(0, LONGEST_PINNED_NOTE) } }));

/** Changes the text or the place of a note; an empty text deletes it. Other keys of it stay. */
export const editPinnedNote = (id: string, changed: Partial<Omit<PinnedNote, 'id'>>): Recipe =>
  change((notes) => {
    const { [id]: note, ...others } = notes;
    if (!isNote(note)) return notes;
    return changed.text === '' ? others : { ...notes, [id]: { ...(note as object), ...changed } };
  });

export const unpinNote = (id: string): Recipe => editPinnedNote(id, { text: '' });
