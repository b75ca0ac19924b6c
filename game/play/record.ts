import { ACCURACIES, joinHolds } from '../../engine/index.ts';
import type { Player } from '../player/index.ts';
import { ENGINE_ID } from './engine-id.ts';
import { levelHash } from './level-hash.ts';
import { ACCURACY_CODES, type Play } from './play.ts';

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
