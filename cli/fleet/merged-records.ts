import FlatQueue from 'flatqueue';
import { LineReader } from './line-reader.ts';

/** Bytes of all results that are in memory at a time, about. */
const MEMORY = 64 * 1024 * 1024;

const LEAST_PIECE = 8 * 1024;
const MOST_PIECE = 256 * 1024;

const NUMBER = /^\{"n":(\d+),/;

/**
 * The records of results in the order of the set.
 * @param results whole results that have each record once between them
 * @throws Error if a number is missing or double
 */
export function* mergedRecords(results: readonly string[]): Generator<Buffer> {
  const piece = Math.max(LEAST_PIECE, Math.min(MOST_PIECE, Math.floor(MEMORY / results.length)));
  const readers = results.map((path) => new LineReader(path, piece));
  const lines: (Buffer | null)[] = [];
  const queue = new FlatQueue<number>();
  const advance = (i: number): void => {
    const line = readers[i].next();
    lines[i] = line;
    const number = line === null ? null : NUMBER.exec(line.toString('latin1', 0, 32));
    // the line of the end has no number
    if (number != null) queue.push(i, Number(number[1]));
  };
  for (const [i, reader] of readers.entries()) {
    reader.next();
    advance(i);
  }
  for (let expected = 0; ; expected++) {
    const n = queue.peekValue();
    if (n === undefined) return;
    if (n !== expected) throw new Error(`expected record ${expected}, found ${n}`);
    const i = queue.pop()!;
    yield lines[i]!;
    advance(i);
  }
}
