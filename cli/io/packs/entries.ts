import { Failure } from '../messages.ts';
import type { Batch, Contents } from './batch.ts';
import { unwrap } from './unwrap.ts';

/** A level or a play of a set. */
export interface Entry {
  /** The path of its file, or where it is in its pack: `pack.tar#a.level.json`, `pack.ndjson#12` for a line, `pack.ndjson#ID`. */
  readonly name: string;
  /** A Failure if its file can't be read. */
  readonly content: Uint8Array | Failure;
}

/**
 * The entries of a batch, in their order.
 * @param readFile reads a file; throws a Failure if it can't be read
 */
export function* entriesOf({ source }: Batch, contents: Contents, readFile: (path: string) => Uint8Array): Generator<Entry> {
  if ('files' in source) {
    for (const name of source.files) yield { name, content: read(name, readFile) };
    return;
  }
  const { pack, kind, labels, bytes, ends } = source;
  let from = 0;
  for (const [i, label] of labels.entries()) {
    const content = bytes.subarray(from, ends[i]);
    from = ends[i];
    if (kind === 'tar' || contents === 'plays') yield { name: `${pack}#${label}`, content };
    else {
      const { id, content: level } = unwrap(content);
      yield { name: `${pack}#${id ?? label}`, content: level };
    }
  }
}

function read(file: string, readFile: (path: string) => Uint8Array): Uint8Array | Failure {
  try {
    return readFile(file);
  } catch (error) {
    if (error instanceof Failure) return error;
    throw error;
  }
}
