import { createPlayer, encodePlay, playOf } from '../../game/index.ts';
import { shipped } from '../levels/shipped-pack.ts';

/** The play of a run of a shipped level, as a file contains it. */
export function playOfRun(slug: string, run = 0, challenge: string | null = null): Uint8Array {
  const { level } = shipped(slug);
  const player = createPlayer(level, { replay: level.runs[run].holds });
  while (player.ending === null) player.advance(100);
  return encodePlay(playOf(player, challenge));
}

/** The bytes with one of them changed. */
export function changed(bytes: Uint8Array, at: number): Uint8Array {
  const copy = bytes.slice();
  copy[at < 0 ? bytes.length + at : at] ^= 0x55;
  return copy;
}
