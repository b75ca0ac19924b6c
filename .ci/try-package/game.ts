import {
  createPlayer,
  encodePlay,
  type LevelReading,
  type Player,
  playOf,
  readLevel,
  verifyPlay,
} from 'gravity-quest-toolkit/game';

/** The hash of the level's first run as a play, frame by frame, and what its verification says. */
export function trial(text: string): string {
  const read: LevelReading = readLevel(text);
  if (!read.ok) throw new Error(read.message);
  const player: Player = createPlayer(read.level, { replay: read.level.runs[0].holds });
  for (let frame = 0; player.ending === null && frame < 10_000; frame++) player.advance(frame % 3 === 0 ? 33 : 7);
  const verified = verifyPlay(read.level, encodePlay(playOf(player)));
  // @ts-expect-error: the types are known, and this is none of them
  const tick: string = player.tick;
  return tick === undefined ? '' : `${player.ending?.outcome} ${player.hash} ${verified.verdict}`;
}
