import { compile, simulate, TICK_RATE, WorkBudget } from '../../engine/index.ts';
import { createVerifier, encodePlay, type Play } from '../../game/index.ts';
import type { Level, OwnRules } from '../../schema/index.ts';
import { readBytes } from '../io/index.ts';
import { Failure } from '../terminal/index.ts';
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

/** Ticks by which the end of a play may move when its level changes. */
const NEAR = 120;
/** Levels that are tried for a play. */
const MOST_LEVELS = 200;
/** Work for each of them, pieces of motion. */
const WORK = 20_000;

/** A level that may be what the level of a play has become. */
export interface Candidate {
  readonly known: KnownLevel;
  /** Whether the inputs of the play lead to just what it claims there. */
  readonly isExact: boolean;
}

const isAsClaimed = (play: Play, { level, hash }: KnownLevel): boolean =>
  createVerifier(level).verify(encodePlay({ ...play, level: hash }), { accuracy: play.accuracy, maxWork: WORK }).verdict === 'ok';

/** The level on which the inputs of a play end as it claims, at nearly the same tick; null if they do so on none. */
export function candidateFor(play: Play, levels: readonly KnownLevel[]): Candidate | null {
  const { tick, minerals, outcome } = play.claim;
  // whatever she does, she is somewhere in between on every level
  if (outcome === 'left' || outcome === 'timeout') return null;
  let nearest: KnownLevel | null = null;
  let distance = NEAR + 1;
  for (const known of levels.slice(0, MOST_LEVELS)) {
    const run = simulate(compile(known.level, play.accuracy), play.holds, {
      maxTime: (tick + NEAR) / TICK_RATE,
      budget: new WorkBudget(WORK),
      record: false,
    });
    const apart = Math.abs(run.tick - tick);
    if (run.outcome !== outcome || run.minerals.length !== minerals || apart >= distance) continue;
    if (isAsClaimed(play, known)) return { known, isExact: true };
    nearest = known;
    distance = apart;
  }
  return nearest === null ? null : { known: nearest, isExact: false };
}
