import { ACCURACIES, type AccuracyName, joinHolds, type Outcome } from '../../engine/index.ts';
import type { Hold } from '../../schema/basics/index.ts';
import type { Player } from '../player/index.ts';
import { ENGINE_ID } from './engine-id.ts';
import { ACCURACY_CODES } from './format.ts';
import { levelHash } from './level-hash.ts';

/** How a play ended: as a run does, or `left` if the player left while it went on. */
export type PlayOutcome = Outcome | 'left';

/** What a play says of itself. */
export interface PlayClaim {
  /** Ticks of 1/60 s that were played, as {@link Player.tick} says. */
  readonly tick: number;
  /** Minerals that were collected. */
  readonly minerals: number;
  /** How it ended. */
  readonly outcome: PlayOutcome;
}

/**
 * A recorded play, as a `.gqr` file contains it: what the player did, and what it claims to have led to. The player's inputs
 * alone decide the play, so `verifyPlay` can repeat it.
 */
export interface Play {
  /** The identity of the engine that it was played with, 16 hexadecimal digits. See {@link ENGINE_ID}. */
  readonly engine: string;
  /** The hash of the level, 64 hexadecimal digits. See {@link levelHash}. */
  readonly level: string;
  /** The accuracy. */
  readonly accuracy: AccuracyName;
  /** What the server gave the player before the play, 32 hexadecimal digits; null if there was none. */
  readonly challenge: string | null;
  /**
   * The holds, half-open intervals [press, release) in ticks of 1/60 s: sorted, and neither empty nor touching each other. One
   * that lasted to the end of the play has its last tick as release.
   */
  readonly holds: readonly Hold[];
  /** What it claims. */
  readonly claim: PlayClaim;
  /** The hash of the play, 16 hexadecimal digits. */
  readonly hash: string;
  /** The hashes at every multiple of 600 ticks. They say in which of these spans a replay first differs. */
  readonly checkpoints: readonly string[];
}

/**
 * Takes the play of a player as it is now: to the end, or as far as it has come.
 *
 * @param player - the player
 * @param challenge - what the server gave before the play, 32 hexadecimal digits; null when left out
 * @returns the play, for {@link encodePlay}
 * @throws {RangeError} when the player has a custom accuracy, which a play can't say
 *
 * @example
 * ```ts
 * const player = createPlayer(level, { onEnd: () => send(encodePlay(playOf(player))) });
 * ```
 */
export function playOf(player: Player, challenge: string | null = null): Play {
  const { accuracy: setting } = player.scene;
  const accuracy = ACCURACY_CODES.find((name) => ACCURACIES[name].name === setting.name);
  if (accuracy === undefined) {
    throw new RangeError(`playOf: expected an accuracy with a name (${ACCURACY_CODES.join(', ')}), found "${setting.name}"`);
  }
  return {
    engine: ENGINE_ID,
    level: levelHash(player.level),
    accuracy,
    challenge,
    holds: joinHolds(player.holds),
    claim: { tick: player.tick, minerals: player.mineralCount, outcome: player.ending?.outcome ?? 'left' },
    hash: player.hash,
    checkpoints: [...player.checkpoints],
  };
}
