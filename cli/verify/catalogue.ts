import type { Level, OwnRules } from '../../schema/index.ts';
import { Failure, readBytes } from '../io/index.ts';
import type { EngineModule } from './engine-module.ts';

/** A level that plays may be of. */
export interface KnownLevel {
  readonly file: string;
  readonly name: string;
  readonly hash: string;
  readonly level: Level;
}

/** The levels that plays may be of, found by their hash. */
export interface Catalogue {
  /** The level with a hash; of several files with one content, the first. */
  find(hash: string): KnownLevel | null;
  readonly levels: readonly KnownLevel[];
  /** Why files are left out: each names its file, which is no level or can't be read. */
  readonly unusable: readonly string[];
}

/** Reads levels and computes their hashes, as an engine sees them. */
export function readCatalogue(files: readonly string[], rules: OwnRules, engine: EngineModule): Catalogue {
  const byHash = new Map<string, KnownLevel>();
  const levels: KnownLevel[] = [];
  const unusable: string[] = [];
  for (const file of files) {
    let bytes: Uint8Array;
    try {
      bytes = readBytes(file);
    } catch (error) {
      if (!(error instanceof Failure)) throw error;
      unusable.push(error.message);
      continue;
    }
    const level = engine.readLevel(bytes, rules);
    if (level === null) {
      unusable.push(`${file}: not a valid level`);
      continue;
    }
    const known: KnownLevel = { file, name: level.name, hash: engine.levelHash(level), level };
    levels.push(known);
    if (!byHash.has(known.hash)) byHash.set(known.hash, known);
  }
  return { find: (hash) => byHash.get(hash) ?? null, levels, unusable };
}
