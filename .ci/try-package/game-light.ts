import {
  aliens,
  type CreateLightPlayer,
  composePlayer,
  type GamePart,
  readLevel,
  repulsors,
} from 'gravity-quest-toolkit/game/light';

/** The hash of the level's first run as a play, by a player of a few parts. */
export function trial(text: string): string {
  const read = readLevel(text);
  if (!read.ok) throw new Error(read.message);
  const parts: GamePart[] = [aliens, repulsors];
  const createPlayer: CreateLightPlayer = composePlayer(parts);
  const player = createPlayer(read.level, { replay: read.level.runs[0].holds });
  for (let frame = 0; player.ending === null && frame < 10_000; frame++) player.advance(frame % 3 === 0 ? 33 : 7);
  // @ts-expect-error: the types are known, and this is none of them
  const tick: string = player.tick;
  return tick === undefined ? '' : `${player.ending?.outcome} ${player.hash}`;
}
