import { compile, createSimulation, DEFAULT_ACCURACY, type Scene } from '../../engine/index.ts';
import type { Level } from '../../schema/basics/index.ts';
import type { PlayerOptions } from './options.ts';
import { LevelPlayer, type Player } from './player.ts';

export { countCollected } from './body.ts';

export type { Ghost } from './ghost.ts';
export { holdsOf } from './gun.ts';
export type { AttemptOptions, GhostSource, PlayEnding, PlayEvent, PlayerOptions } from './options.ts';
export { CHECKPOINT_TICKS, PlayHash } from './play-hash.ts';
export { LevelPlayer, type Player, type PlayerSnapshot } from './player.ts';

/**
 * Creates a player at the start of a level.
 *
 * @param level - a valid level, or a scene that {@link compile} made of one
 * @param options - accuracy, limits and callbacks, and what the attempt begins with
 * @returns the player
 *
 * @example
 * ```ts
 * const player = createPlayer(level, { onEvent: ({ event, x, y }) => sparks(event.type, x, y) });
 * addEventListener('pointerdown', () => player.press());
 * addEventListener('pointerup', () => player.release());
 * const pose = new Float64Array(6);
 * function frame(ms) {
 *   player.advance(ms);
 *   player.readPose(pose);
 *   draw(pose[0], pose[1]);
 * }
 * ```
 */
export function createPlayer(level: Level | Scene, options: PlayerOptions = {}): Player {
  const scene = 'targets' in level ? level : compile(level, options.accuracy ?? DEFAULT_ACCURACY);
  return new LevelPlayer(scene, options, (of, events) => createSimulation(of, undefined, events));
}
