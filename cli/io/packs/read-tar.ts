import type { Batch, BatchMaker } from './batch.ts';
import { TarArchive } from './tar-archive.ts';

/**
 * The files of an archive whose names pass.
 * @throws Failure if it is no archive, is cut off or damaged, if a name that passes is not that of a file, or if there is more
 * after the archive's end
 */
export async function* readTar(
  path: string,
  stream: AsyncIterable<Buffer>,
  maker: BatchMaker,
  passes: (name: string) => boolean,
): AsyncGenerator<Batch> {
  const archive = new TarArchive(path, passes, (name, pieces) => maker.add(name, pieces));
  for await (const piece of stream) {
    archive.write(piece);
    yield* maker.take();
  }
  archive.end();
  yield* maker.take();
}
