import { type LevelFile, LIMITS, LINE_BREAK, levelSchema } from '../../../schema/index.ts';
import { cut, type Fields, refuse, settleFields } from './settle-fields.ts';

const { shape: runShape } = levelSchema.shape.runs.unwrap().element;
const RUN: Fields = { shape: runShape, limits: {}, required: [] };
const NOTE: Fields = { shape: runShape.notes.unwrap().element.shape, limits: {}, required: ['tick', 'text'] };

const LONGEST_NAME = 80;

export type RunFile = NonNullable<LevelFile['runs']>[number];
type Notes = RunFile['notes'];

const tickOf = (tick: number): number => Math.min(LIMITS.tick, Math.max(0, Math.round(tick)));

function settleHolds(holds: RunFile['holds']): RunFile['holds'] {
  if (holds.length > LIMITS.holds) refuse(`a run can have ${LIMITS.holds} holds at most`, 'Delete some of them.');
  let isFine = true;
  for (const [press, release] of holds) {
    if (Number.isNaN(press + release)) refuse('a hold would not begin and end at a number', 'Type a whole number of ticks.');
    if (!Object.is(tickOf(press), press) || tickOf(release) !== release || release <= press) isFine = false;
  }
  if (isFine) return holds;
  const settled = holds.map(([press, release]): [number, number] => [tickOf(press), tickOf(release)]);
  return settled.filter(([press, release]) => release > press);
}

/** A text on one line, as a note has it; '' if nothing is left. */
function settleText(text: unknown): string {
  if (typeof text !== 'string') refuse(`a note can't say ${JSON.stringify(text)}`, 'Type a text.');
  const line = (text as string).split(LINE_BREAK).join(' ').trim();
  return cut(line, LIMITS.note).trim();
}

function settleNotes(notes: Notes): Notes {
  if (notes === undefined) return undefined;
  if (notes.length > LIMITS.notes) refuse(`a run can have ${LIMITS.notes} notes at most`, 'Delete some of them.');
  let isFine = true;
  const settled = notes.map((note) => {
    if (Number.isNaN(note.tick)) refuse('a note would not be at a number', 'Type a whole number of ticks.');
    const [tick, text] = [tickOf(note.tick), settleText(note.text)];
    const now = settleFields(Object.is(tick, note.tick) && text === note.text ? note : { ...note, tick, text }, NOTE, 'a note');
    if (now !== note) isFine = false;
    return now;
  });
  if (isFine) return notes;
  const left = settled.filter(({ text }) => text !== '');
  return left.length === 0 ? undefined : left;
}

/** A name that is not empty and not too long. */
export function settleName(name: unknown, most: number, what: string): string {
  if (typeof name !== 'string' || name === '') refuse(`${what} needs a name`, 'Type a name.');
  return cut(name as string, most);
}

/** A valid run, the same object if it is one. */
export function settleRun(value: RunFile): RunFile {
  const { name, holds, notes, ...others } = value;
  const settled = { name: settleName(name, LONGEST_NAME, 'a run'), holds: settleHolds(holds) };
  const noted = settleNotes(notes);
  const rest = settleFields(others, RUN, 'a run');
  const isSame = settled.name === name && settled.holds === holds && noted === notes && rest === others;
  return isSame ? value : { ...settled, ...(noted === undefined ? {} : { notes: noted }), ...rest };
}
