/** How a pack holds its entries, and how it is compressed. */
export interface PackFormat {
  /** `ndjson`: a level or a play a line; `tar`: an archive of files. */
  readonly kind: 'ndjson' | 'tar';
  readonly compression: 'gzip' | 'zstd' | null;
}

const PACK = /\.(ndjson|tar)(?:\.(gz|zst))?$|\.(tgz)$/i;

/** The format of a pack by the name of its file; null if the file is no pack. */
export function packFormat(path: string): PackFormat | null {
  const found = PACK.exec(path);
  if (found === null) return null;
  const [, kind, compression, short] = found;
  if (short !== undefined) return { kind: 'tar', compression: 'gzip' };
  const compressions = { gz: 'gzip', zst: 'zstd' } as const;
  return {
    kind: kind.toLowerCase() as PackFormat['kind'],
    compression: compression === undefined ? null : compressions[compression.toLowerCase() as keyof typeof compressions],
  };
}

/** The first of the files that is a pack; undefined if none is. */
export const firstPack = (files: readonly string[]): string | undefined => files.find((file) => packFormat(file) !== null);
