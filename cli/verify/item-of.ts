import { entryName, packFormat } from '../packs/index.ts';
import { MOST_BYTES, readLine } from './lines.ts';
import type { PlayItem } from './verify-plays.ts';

/**
 * A play of a set.
 * @param name its path, or where it is in its pack: `plays.ndjson#12`, `plays.tar#a.gqr`
 */
export function itemOf(name: string, content: Uint8Array): PlayItem {
  const inPack = entryName(name);
  const file = { file: name, line: null, id: null, subject: null };
  const isText = content[0] === 0x7b || content[0] === 0x22;
  if (inPack === null || packFormat(inPack.pack)?.kind !== 'ndjson') {
    return { ...file, content: isText ? { verdict: 'malformed', why: 'expected a play, found text' } : content };
  }
  const text = content.length > MOST_BYTES ? null : Buffer.from(content).toString();
  // lines of white space alone are no entries, but JavaScript knows more kinds of it
  const read = readLine(text) ?? { id: null, verdict: 'malformed' as const, why: 'expected a play, found white space' };
  const place = { file: inPack.pack, line: Number(inPack.label), id: read.id };
  return 'why' in read ? { ...place, subject: null, content: read } : { ...place, subject: read.subject, content: read.bytes };
}
