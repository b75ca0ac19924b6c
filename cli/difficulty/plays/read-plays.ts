import { type Attempt, createPlayReplayer, type PlayReplayer, type RefusedPlay } from '../../../check/plays/index.ts';
import type { Terms } from '../../../engine/index.ts';
import type { PlayVerdict } from '../../../game/index.ts';
import { decodePlay, PLAY_LIMITS, whyOtherEngine } from '../../../game/play/index.ts';
import { readLevel } from '../../../schema/index.ts';
import type { Goal } from '../../../solver/index.ts';
import { readBytes, readRegularFile } from '../../io/index.ts';
import { Failure, systemReason } from '../../terminal/index.ts';
import { readLine } from '../../verify/index.ts';

/** Levels that are ready for replays, of this thread. */
const ready = new Map<string, PlayReplayer>();

/** Reads plays and simulates each once. Throws only if gq itself fails. */
export function readPlays({ sources, levels, terms, goal }: PlayTask): PlayFinding[] {
  const known = new Map(levels.map((level) => [level.hash, level]));
  return sources.map((source) => {
    const bytes = bytesOf(source);
    if (!('bytes' in bytes)) return bytes;
    const { id, subject } = bytes;
    const decoded = decodePlay(bytes.bytes);
    if (!decoded.ok) return { id, subject, kind: 'refused', verdict: decoded.verdict, message: decoded.message };
    const { play } = decoded;
    // a play of another engine is named, whatever its level is
    const why = whyOtherEngine(play);
    if (why !== null) return { id, subject, kind: 'refused', ...why };
    const level = known.get(play.level);
    if (level === undefined) return { id, subject, kind: 'elsewhere', hash: play.level };
    return { id, subject, kind: 'played', hash: play.level, replayed: replayerOf(level, terms, goal).replay(play, 0) };
  });
}

interface Read {
  readonly id: string | null;
  readonly subject: string | null;
  readonly bytes: Uint8Array;
}

function bytesOf(source: PlaySource): Read | PlayFinding {
  const nobody = { id: null, subject: null };
  if ('path' in source) {
    try {
      return { ...nobody, bytes: readRegularFile(source.path, PLAY_LIMITS.bytes) };
    } catch (error) {
      return { ...nobody, kind: 'unreadable', message: systemReason(error) };
    }
  }
  const line = readLine(source.line);
  if (line === null) return { ...nobody, kind: 'empty' };
  const id = line.id === null ? null : String(line.id);
  if ('verdict' in line) return { id, subject: null, kind: 'refused', verdict: line.verdict, message: line.why };
  return { id, subject: line.subject, bytes: line.bytes };
}

function replayerOf({ hash, file }: PlayedLevel, terms: Terms, goal: Goal): PlayReplayer {
  const key = JSON.stringify([hash, goal, terms]);
  const known = ready.get(key);
  if (known !== undefined) return known;
  const read = readLevel(readBytes(file), terms);
  if (!read.ok) throw new Failure(`${file} has changed meanwhile: run gq again`);
  const replayer = createPlayReplayer(read.level, terms, goal);
  ready.set(key, replayer);
  return replayer;
}

/** A play that a worker reads: the path of its file, or its line; null for a line that is too long. */
export type PlaySource = { readonly path: string } | { readonly line: string | null };

/** A level that plays may be of. */
export interface PlayedLevel {
  readonly hash: string;
  readonly file: string;
}

/** Plays that a worker reads and simulates together. */
export interface PlayTask {
  readonly sources: readonly PlaySource[];
  readonly levels: readonly PlayedLevel[];
  readonly terms: Terms;
  readonly goal: Goal;
}

/** What a source turned out to be. */
export type PlayFinding = {
  /** What the line calls itself; null if it has no name. */
  readonly id: string | null;
  /** Who played, as the line says; null if it does not. */
  readonly subject: string | null;
} & (
  | { readonly kind: 'empty' }
  /** The index of its play is 0. */
  | { readonly kind: 'played'; readonly hash: string; readonly replayed: Attempt | RefusedPlay }
  | { readonly kind: 'elsewhere'; readonly hash: string }
  | { readonly kind: 'refused'; readonly verdict: Exclude<PlayVerdict, 'ok'>; readonly message: string }
  | { readonly kind: 'unreadable'; readonly message: string }
);
