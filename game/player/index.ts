export { countCollected } from './body.ts';
export { createPlayer } from './create-player.ts';
export type { Ghost } from './ghost.ts';
export { holdsOf } from './gun.ts';
export type { AttemptOptions, GhostSource, PlayEnding, PlayEvent, PlayerOptions } from './options.ts';
export { CHECKPOINT_TICKS, PlayHash } from './play-hash.ts';
export { LevelPlayer, type Player, type PlayerSnapshot } from './player.ts';
