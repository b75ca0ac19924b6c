import {
  type Best,
  createPack,
  decodePlay,
  encodePlay,
  levelHash,
  type Play,
  type Player,
  playFromText,
  playOf,
  playToText,
} from 'gravity-quest-toolkit/game';
import type { Hold } from './ghosts.ts';
import type { PlayableEntry, Terms } from './pack.ts';
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

/** The play in a text; null if there is none. */
function playIn(text: string | null | undefined): Play | null {
  const bytes = text == null ? null : playFromText(text);
  const decoded = bytes === null ? null : decodePlay(bytes);
  return decoded?.ok === true ? decoded.play : null;
}

export function createProgress(entries: readonly PlayableEntry[], { accuracy }: Terms, store: Store): Progress {
  // a time counts for the version of the level and the accuracy at which it was reached
  const versions = new Map(entries.map(({ id, level }) => [id, `${id}@${levelHash(level).slice(0, VERSION_LENGTH)}`]));
  const minerals = new Map(entries.map(({ id, level }) => [id, level.minerals.length]));
  const keyFor = (id: string): string => `${versions.get(id) ?? id}@${accuracy}`;
  const packOf = (keyed: (id: string) => string) =>
    createPack(
      entries.map(({ id, level }) => ({ id: keyed(id), level })),
      store,
      keyOf('progress'),
    );
  const pack = packOf(keyFor);
  // earlier pages did not tell accuracies apart, but each play names its own
  const earlier = packOf((id) => versions.get(id) ?? id);
  for (const { id } of entries) {
    const best = earlier.best(versions.get(id) ?? id);
    if (best !== null && playIn(best.play)?.accuracy === accuracy) pack.record(keyFor(id), best);
  }
  return {
    best(id) {
      const best = pack.best(keyFor(id));
      // what the browser has kept may be of anyone
      return best === null ? null : { ...best, minerals: Math.min(best.minerals, minerals.get(id) ?? 0) };
    },
    bestHolds: (id) => playIn(pack.best(keyFor(id))?.play)?.holds ?? null,
    isUnlocked: (id) => pack.isUnlocked(keyFor(id)),
    record: (id, player) =>
      pack.record(keyFor(id), {
        tick: player.tick,
        minerals: player.collectedCount,
        play: playToText(encodePlay(playOf(player))),
      }),
  };
}
