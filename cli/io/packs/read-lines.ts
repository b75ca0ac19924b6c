import { MAX_FILE_SIZE } from '../../../schema/basics/index.ts';
import type { Batch, BatchMaker } from './batch.ts';

export const NEWLINE = 0x0a;

/** Of a longer line only slightly more than this is kept, which readers then refuse. */
const MOST_BYTES = MAX_FILE_SIZE + 4096;

/** Whether a line has only white space. */
export const isBlank = (pieces: readonly Uint8Array[]): boolean =>
  pieces.every((piece) => piece.length < 1024 && piece.every((byte) => byte === 0x20 || byte === 0x09 || byte === 0x0d));

/** The lines of a pack. Lines of white space alone don't count. */
export async function* readLines(stream: AsyncIterable<Buffer>, maker: BatchMaker): AsyncGenerator<Batch> {
  let number = 0;
  let length = 0;
  let pieces: Uint8Array[] = [];
  const take = (piece: Uint8Array): void => {
    if (piece.length === 0) return;
    if (length < MOST_BYTES) pieces.push(piece.subarray(0, MOST_BYTES - length));
    length += piece.length;
  };
  const endLine = (): void => {
    number++;
    if (!isBlank(pieces)) maker.add(number, pieces);
    pieces = [];
    length = 0;
  };
  for await (const piece of stream) {
    let from = 0;
    for (let at = piece.indexOf(NEWLINE); at >= 0; at = piece.indexOf(NEWLINE, from)) {
      take(piece.subarray(from, at));
      endLine();
      from = at + 1;
    }
    // a stream may use the memory of a piece again
    take(Buffer.from(piece.subarray(from)));
    yield* maker.take();
  }
  if (length > 0) endLine();
  yield* maker.take();
}
