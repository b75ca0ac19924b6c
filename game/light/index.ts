import { DEFAULT_ACCURACY } from '../../engine/index.ts';
import { composeEngine, type GamePart } from '../../engine/light/index.ts';
import type { Level } from '../../schema/basics/index.ts';
import { LevelPlayer, type Player, type PlayerOptions } from '../player/index.ts';

// The game for bundles that are small: the same functions, and those parts of the game that levels call for.
export { aliens, type GamePart, manyObjects, recoil, repulsors, winds, wormholes } from '../../engine/light/index.ts';
export {
  type PlainLevelReading as LevelReading,
  type ReadPlainLevelOptions as ReadLevelOptions,
  readPlainLevel as readLevel,
} from '../../schema/plain/index.ts';

/** Options of a player that {@link composePlayer} makes: it plays at the default accuracy alone. */
export type LightPlayerOptions = Omit<PlayerOptions, 'accuracy'>;

/** Creates a player at the start of a level; see `createPlayer` of the complete game. */
export type CreateLightPlayer = (level: Level, options?: LightPlayerOptions) => Player;

/**
 * Composes a `createPlayer` of the parts of the game that your levels call for, so that a bundle has no others. Every level can
 * have the gun, hot and cold asteroids, novae and minerals. Plays are the same as those of the complete `createPlayer` at the
 * default accuracy, bit for bit. A level that calls for a part that is not included is refused, never played differently.
 *
 * @param parts - the other parts that this module exports, such as `aliens`
 * @returns a function that creates a player of a level; it throws a RangeError when the level calls for another part, or when
 * the options name another accuracy
 *
 * @example
 * ```ts
 * import { aliens, composePlayer, readLevel, repulsors } from 'gravity-quest-toolkit/game/light';
 *
 * const createPlayer = composePlayer([aliens, repulsors]);
 * const reading = readLevel(text);
 * if (!reading.ok) throw new Error(reading.message);
 * const player = createPlayer(reading.level);
 * ```
 */
export function composePlayer(parts: readonly GamePart[] = []): CreateLightPlayer {
  const engine = composeEngine(parts);
  return (level, options = {}) => {
    // for programs without types
    const { accuracy = DEFAULT_ACCURACY } = options as PlayerOptions;
    if (accuracy !== DEFAULT_ACCURACY) {
      const found = typeof accuracy === 'string' ? accuracy : accuracy.name;
      throw new RangeError(
        `expected the accuracy ${DEFAULT_ACCURACY}, found ${found}. Import createPlayer of gravity-quest-toolkit/game for others.`,
      );
    }
    return new LevelPlayer(engine.compile(level), options, engine.createSimulation);
  };
}
