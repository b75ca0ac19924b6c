import { PLAY_LIMITS, playFromText } from '../../game/index.ts';
import { strictJson } from '../../schema/json/index.ts';
import { entryName, packFormat } from '../io/index.ts';
import { shellPath } from '../terminal/index.ts';
import type { PlayItem } from './verify-plays.ts';

/** Bytes of the longest line that is read: a play of the largest size as text, and room for its name. */
const MOST_BYTES = 2 * PLAY_LIMITS.bytes;

const NEWLINE = 0x0a;

/** A line of standard input. */
interface InputLine {
  /** From 1. */
  readonly number: number;
  /** null: the line is longer than any play. */
  readonly text: string | null;
}

/** Cuts a stream into lines without keeping more than one of them. Gives those of each piece of the stream together. */
export async function* linesOf(stream: AsyncIterable<Uint8Array>): AsyncGenerator<InputLine[]> {
  let number = 0;
  let length = 0;
  let pieces: Uint8Array[] = [];
  const take = (piece: Uint8Array): void => {
    length += piece.length;
    if (length > MOST_BYTES) pieces = [];
    else pieces.push(piece);
  };
  const line = (): InputLine => {
    const text = length > MOST_BYTES ? null : Buffer.concat(pieces).toString();
    length = 0;
    pieces = [];
    return { number: ++number, text };
  };
  for await (const piece of stream) {
    const lines: InputLine[] = [];
    let from = 0;
    for (let at = piece.indexOf(NEWLINE); at >= 0; at = piece.indexOf(NEWLINE, from)) {
      take(piece.subarray(from, at));
      lines.push(line());
      from = at + 1;
    }
    // the stream may use the memory of its piece again
    if (from < piece.length) take(piece.slice(from));
    yield lines;
  }
  if (length > 0) yield [line()];
}

/** What a line of standard input says. */
type SubmittedPlay =
  | { readonly id: string | number | null; readonly subject: string | null; readonly bytes: Uint8Array }
  | { readonly id: string | number | null; readonly verdict: 'malformed' | 'too-long'; readonly why: string };

const EXPECTED = 'expected {"id": ..., "play": "<base64url>"} or the base64url of a play';

/** Reads a line: a play as text, with or without quotes, or an object with it. null for an empty line. */
export function readLine(text: string | null): SubmittedPlay | null {
  if (text === null)
    return { id: null, verdict: 'too-long', why: `expected a line of at most ${MOST_BYTES} bytes, found a longer one` };
  const trimmed = text.trim();
  if (trimmed === '') return null;
  if (!/^[{"[]/.test(trimmed)) return submitted(null, null, trimmed);
  const json = strictJson(trimmed);
  if (!json.ok) {
    const column = text.indexOf(trimmed) + json.column;
    return { id: null, verdict: 'malformed', why: `${EXPECTED}; at column ${column}: ${json.message}` };
  }
  const { value } = json;
  if (typeof value === 'string') return submitted(null, null, value);
  if (typeof value !== 'object' || value === null || Array.isArray(value)) {
    return { id: null, verdict: 'malformed', why: `${EXPECTED}, found a list` };
  }
  const { id = null, play, subject = null } = value as { id?: unknown; play?: unknown; subject?: unknown };
  if (id !== null && typeof id !== 'string' && typeof id !== 'number') {
    return { id: null, verdict: 'malformed', why: 'expected an "id" that is a text or a number' };
  }
  if (subject !== null && typeof subject !== 'string')
    return { id, verdict: 'malformed', why: 'expected a "subject" that is a text' };
  if (typeof play !== 'string') return { id, verdict: 'malformed', why: `${EXPECTED}, found no text as "play"` };
  return submitted(id, subject, play);
}

function submitted(id: string | number | null, subject: string | null, text: string): SubmittedPlay {
  const bytes = playFromText(text);
  if (bytes !== null) return { id, subject, bytes };
  if ((text.length * 6) / 8 >= PLAY_LIMITS.bytes + 1 && /^[\w-]*$/.test(text)) {
    return { id, verdict: 'too-long', why: `expected a play of at most ${PLAY_LIMITS.bytes} bytes, found a longer one` };
  }
  return { id, verdict: 'malformed', why: 'expected the base64url of a play: letters, digits, - and _ without padding' };
}

/**
 * A play of a set.
 * @param name its path, or where it is in its pack: `plays.ndjson#12`, `plays.tar#a.gqr`
 */
export function itemOf(name: string, content: Uint8Array): PlayItem {
  const inPack = entryName(name);
  if (inPack === null || packFormat(inPack.pack)?.kind !== 'ndjson') return itemOfFile(name, content);
  const text = content.length > MOST_BYTES ? null : Buffer.from(content).toString();
  const line = Number(inPack.label);
  const item = itemOfLine(inPack.pack, line, text);
  if (item !== null) return item;
  // lines of white space alone are no entries, but JavaScript knows more kinds of it
  const why = 'expected a play, found white space';
  return { file: inPack.pack, line, id: null, subject: null, content: { verdict: 'malformed', why } };
}

/** The play in a file. */
export function itemOfFile(file: string, content: Uint8Array): PlayItem {
  const isText = content[0] === 0x7b || content[0] === 0x22;
  const why = `expected a play, found text; if its lines are plays: gq verify - < ${shellPath(file)}`;
  return { file, line: null, id: null, subject: null, content: isText ? { verdict: 'malformed', why } : content };
}

/** The play in a line; null if there is none. @param file the pack; null for standard input */
export function itemOfLine(file: string | null, line: number, text: string | null): PlayItem | null {
  const read = readLine(text);
  if (read === null) return null;
  const place = { file, line, id: read.id };
  return 'why' in read ? { ...place, subject: null, content: read } : { ...place, subject: read.subject, content: read.bytes };
}
