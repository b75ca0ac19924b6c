import { createHash } from 'node:crypto';

// A shard is a text of lines. The first names the format. Each other one is a record: key, checksum of key and text, text. A
// text is JSON, so it has no line breaks. Whatever happens to the bytes of a shard, a record is used only if its checksum is
// right, so damage costs no more than the records that it touches.

const FORMAT = Buffer.from('gq cache 1\n');
const DIGITS = 64;
const CHECK_DIGITS = 32;
const TEXT_AT = DIGITS + 1 + CHECK_DIGITS + 1;
const NEWLINE = 0x0a;

/** A line of a shard, with its line break. */
export type RecordLine = Uint8Array;

const checksum = (key: string, text: string | Uint8Array): string =>
  createHash('sha256').update(key).update(text).digest('hex').slice(0, CHECK_DIGITS);

/** @param text has no line breaks */
export const makeRecord = (key: string, text: string): RecordLine => Buffer.from(`${key} ${checksum(key, text)} ${text}\n`);

/** The text of a record; null if the record is damaged, or made for another key. */
export function textOf(line: RecordLine, key: string): string | null {
  const bytes = Buffer.from(line.buffer, line.byteOffset, line.byteLength);
  const text = bytes.subarray(TEXT_AT, -1);
  return bytes.toString('latin1', 0, TEXT_AT) === `${key} ${checksum(key, text)} ` ? text.toString() : null;
}

/** The records of a shard by their keys, in their order, damaged ones included; none if the bytes are no shard. */
export function splitShard(bytes: Uint8Array): Map<string, RecordLine> {
  const shard = Buffer.from(bytes.buffer, bytes.byteOffset, bytes.byteLength);
  const lines = new Map<string, RecordLine>();
  if (!shard.subarray(0, FORMAT.length).equals(FORMAT)) return lines;
  for (let start = FORMAT.length; start < shard.length; ) {
    const end = shard.indexOf(NEWLINE, start);
    // the last line of a torn file
    if (end < 0) break;
    if (end - start >= TEXT_AT) lines.set(shard.toString('latin1', start, start + DIGITS), shard.subarray(start, end + 1));
    start = end + 1;
  }
  return lines;
}

export const joinShard = (lines: Iterable<RecordLine>): Uint8Array => Buffer.concat([FORMAT, ...lines]);
