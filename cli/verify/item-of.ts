import { entryName, packFormat, shellPath } from '../io/index.ts';
import { MOST_BYTES, readLine } from './lines.ts';
import type { PlayItem } from './verify-plays.ts';

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
