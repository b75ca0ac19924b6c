import { createPlayer, encodePlay, type PlayerOptions, playOf } from '../../game/index.ts';
import { type Hold, type LevelFile, resolveLevel } from '../../schema/index.ts';

/**
 * The content of a `.gqr` file of somebody who played these holds.
 * @param until the tick at which they left; by default they play to the end
 */
export function recordedPlay(
  file: LevelFile,
  holds: readonly Hold[],
  until = Number.POSITIVE_INFINITY,
  options: PlayerOptions = {},
): Uint8Array {
  const player = createPlayer(resolveLevel(file), { ...options, replay: holds });
  while (player.ending === null && player.tick < until) player.advance(1000 / 60);
  return encodePlay(playOf(player));
}
