import {
  type Best,
  createPack,
  decodePlay,
  encodePlay,
  levelHash,
  type Player,
  playFromText,
  playOf,
  playToText,
} from 'gravity-quest-toolkit/game';
import type { Hold } from './ghosts.ts';
import type { PlayableEntry } from './pack.ts';
import { keyOf, type Store } from './settings.ts';

/** How far the player has come in a pack. */
export interface Progress {
  /** The best play of a level; null if it has not been completed. */
  best(id: string): Best | null;
  /** Its holds, for a ghost. */
  bestHolds(id: string): readonly Hold[] | null;
  isUnlocked(id: string): boolean;
  /** Keeps the play of a completed level if it is the best so far. @returns whether it is */
  record(id: string, player: Player): boolean;
}

/** Characters of a level's hash that tell its versions apart. */
const VERSION_LENGTH = 8;

export function createProgress(entries: readonly PlayableEntry[], store: Store): Progress {
  // a time counts for the version of the level in which it was reached
  const keys = new Map(entries.map(({ id, level }) => [id, `${id}@${levelHash(level).slice(0, VERSION_LENGTH)}`]));
  const minerals = new Map(entries.map(({ id, level }) => [id, level.minerals.length]));
  const keyFor = (id: string): string => keys.get(id) ?? id;
  const pack = createPack(
    entries.map(({ id, level }) => ({ id: keyFor(id), level })),
    store,
    keyOf('progress'),
  );
  return {
    best(id) {
      const best = pack.best(keyFor(id));
      // what the browser has kept may be of anyone
      return best === null ? null : { ...best, minerals: Math.min(best.minerals, minerals.get(id) ?? 0) };
    },
    bestHolds(id) {
      const text = pack.best(keyFor(id))?.play;
      const bytes = text == null ? null : playFromText(text);
      const decoded = bytes === null ? null : decodePlay(bytes);
      return decoded?.ok === true ? decoded.play.holds : null;
    },
    isUnlocked: (id) => pack.isUnlocked(keyFor(id)),
    record: (id, player) =>
      pack.record(keyFor(id), {
        tick: player.tick,
        minerals: player.collectedCount,
        play: playToText(encodePlay(playOf(player))),
      }),
  };
}
