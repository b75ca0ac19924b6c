import { Parser, type ReadEntry } from 'tar';
import { MAX_FILE_SIZE } from '../../schema/basics/index.ts';
import { Failure } from '../failure.ts';
import { namedPath } from '../shown-path.ts';
import type { Batch, BatchMaker } from './batch.ts';

/** Of a longer file only slightly more than this is kept, which readers then refuse. */
const MOST_BYTES = MAX_FILE_SIZE + 4096;

/**
 * The files of an archive whose names pass.
 * @throws Failure if it is no archive, or is cut off or damaged
 */
export async function* readTar(
  path: string,
  stream: AsyncIterable<Buffer>,
  maker: BatchMaker,
  passes: (name: string) => boolean,
): AsyncGenerator<Batch> {
  let broken: Error | null = null;
  const parser = new Parser({
    strict: true,
    onReadEntry(entry: ReadEntry) {
      if (entry.type !== 'File' || !passes(entry.path)) {
        entry.resume();
        return;
      }
      const pieces: Uint8Array[] = [];
      let length = 0;
      entry.on('data', (piece: Buffer) => {
        if (length < MOST_BYTES) pieces.push(Buffer.from(piece.subarray(0, MOST_BYTES - length)));
        length += piece.length;
      });
      entry.on('end', () => maker.add(entry.path, pieces));
    },
  });
  parser.on('error', (error: Error) => {
    broken ??= error;
  });
  const refuseBroken = (): void => {
    if (broken === null) return;
    throw new Failure(
      `${namedPath(path)}: it is no tar archive, or it is cut off or damaged: ${(broken as Error).message.split('\n')[0]}`,
    );
  };
  for await (const piece of stream) {
    parser.write(piece);
    refuseBroken();
    yield* maker.take();
  }
  parser.end();
  refuseBroken();
  yield* maker.take();
}
