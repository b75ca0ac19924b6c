import { Failure, namedPath } from '../messages.ts';
import { type Batch, type BatchLimits, BatchMaker, type Contents, sizeOf } from './batch.ts';
import { packFormat } from './formats.ts';
import { openPack } from './open-pack.ts';
import { readLines } from './read-lines.ts';

/** Which files of an archive count. */
const COUNTS: Readonly<Record<Contents, RegExp>> = { levels: /\.level\.json$/, plays: /\.gqr$/ };

const WHAT: Readonly<Record<Contents, string>> = {
  levels: 'level: expected a level a line',
  plays: 'play: expected a play a line',
};
const FILES: Readonly<Record<Contents, string>> = { levels: '*.level.json', plays: '*.gqr' };

/**
 * Reads a set in the order of its paths, a batch at a time, so that it needs no more memory than a few batches.
 * @param paths files and packs
 * @throws Failure if a pack can't be read, is damaged, or contains nothing
 */
export async function* readSet(paths: readonly string[], contents: Contents, limits: BatchLimits): AsyncGenerator<Batch> {
  let first = 0;
  for (let i = 0; i < paths.length; ) {
    const format = packFormat(paths[i]);
    if (format === null) {
      const files: string[] = [];
      while (i < paths.length && files.length < limits.entries && packFormat(paths[i]) === null) files.push(paths[i++]);
      yield { first, source: { files } };
      first += files.length;
      continue;
    }
    const path = paths[i++];
    const before = first;
    const maker = new BatchMaker(path, format.kind, first, limits);
    const stream = openPack(path, format);
    const isCounted = (name: string): boolean => COUNTS[contents].test(name);
    // loaded only for archives, as it takes time
    const batches =
      format.kind === 'tar' ? (await import('./read-tar.ts')).readTar(path, stream, maker, isCounted) : readLines(stream, maker);
    for await (const batch of batches) {
      first += sizeOf(batch);
      yield batch;
    }
    if (first > before) continue;
    const expected = format.kind === 'tar' ? `${contents.slice(0, -1)}: expected ${FILES[contents]} in it` : WHAT[contents];
    throw new Failure(`${namedPath(path)}: it contains no ${expected}`);
  }
}
