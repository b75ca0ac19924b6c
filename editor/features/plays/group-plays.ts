import { decodePlay, ENGINE_ID, type Play } from '../../../game/index.ts';
import type { GivenPlay, RefusedFile } from '../../core/shelf/index.ts';

/** A play that can be read, by an engine that this page has. */
export interface ReadPlay extends GivenPlay {
  readonly play: Play;
}

/** Plays by the hash of their level. */
export interface GroupedPlays {
  readonly byLevel: ReadonlyMap<string, readonly ReadPlay[]>;
  readonly refused: readonly RefusedFile[];
}

/** Reads plays and groups them by level. Those that can't be read, or were played with another engine, are refused. */
export function groupPlays(given: readonly GivenPlay[]): GroupedPlays {
  const byLevel = new Map<string, ReadPlay[]>();
  const refused: RefusedFile[] = [];
  for (const { name, bytes } of given) {
    const decoded = decodePlay(bytes);
    if (!decoded.ok) {
      refused.push({ name, reason: `${decoded.verdict}: ${decoded.message}` });
      continue;
    }
    const { play } = decoded;
    if (play.engine !== ENGINE_ID) {
      refused.push({ name, reason: `unknown-engine: expected a play of engine ${ENGINE_ID}, found one of ${play.engine}` });
      continue;
    }
    const group = byLevel.get(play.level);
    if (group === undefined) byLevel.set(play.level, [{ name, bytes, play }]);
    else group.push({ name, bytes, play });
  }
  return { byLevel, refused };
}

/** Lines of a message. */
const LINES = 4;

/** What was refused, a line each; what there is no room for is counted. */
export function refusedInWords(refused: readonly RefusedFile[]): string {
  const lines = refused.slice(0, LINES).map(({ name, reason }) => `${name}: ${reason}.`);
  const rest = refused.length - lines.length;
  if (rest > 0) lines.push(`${rest} more ${rest === 1 ? 'was' : 'were'} refused as well.`);
  return lines.join('\n');
}
