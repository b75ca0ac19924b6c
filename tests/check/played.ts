import { readFileSync } from 'node:fs';
import {
  collectStatistics,
  createPlayReplayer,
  type PlayedBy,
  type PlayStatistics,
  type Reference,
} from '../../check/plays/index.ts';
import { type AccuracyName, compile, type Terms } from '../../engine/index.ts';
import { createPlayer, type Play, playOf } from '../../game/index.ts';
import { type Hold, type Level, readLevel } from '../../schema/index.ts';
import { createRandom, type Goal } from '../../solver/index.ts';
import { drawShift, shiftHolds, tickNoise } from '../../solver/measure/robustness/index.ts';

/** A shipped level. */
export function shippedLevel(slug: string): Level {
  const read = readLevel(readFileSync(new URL(`../../levels/${slug}.level.json`, import.meta.url)));
  if (!read.ok) throw new Error(`${slug} is not a valid level`);
  return read.level;
}

/** Plays holds as a player of the game would, and records the play. It is left at tick `leftAt` if it goes on then. */
export function playedBy(level: Level, accuracy: AccuracyName = 'precise'): (holds: readonly Hold[], leftAt?: number) => Play {
  const player = createPlayer(compile(level, accuracy), { maxFrame: Number.POSITIVE_INFINITY });
  return (holds, leftAt = 3600) => {
    player.restart({ replay: holds });
    player.advance((leftAt * 1000) / 60);
    return playOf(player);
  };
}

/** Runs whose presses and releases are off by Gaussian noise of `sigma` ms. */
export function noisy(holds: readonly Hold[], sigma: number, count: number, seed: number): Hold[][] {
  const random = createRandom(seed);
  const noise = tickNoise(sigma);
  return Array.from({ length: count }, () =>
    shiftHolds(
      holds,
      holds.flat().map(() => drawShift(noise, random.next())),
    ),
  );
}

/** Simulates plays of a level again and says how players fare, as `gq difficulty --plays` does. */
export function statisticsOf(
  level: Level,
  terms: Terms,
  plays: readonly Play[],
  { goal = { minerals: 'any' }, ...options }: { goal?: Goal; by?: readonly (PlayedBy | null)[]; reference?: Reference } = {},
): PlayStatistics {
  const replayer = createPlayReplayer(level, terms, goal);
  const replayed = plays.map((play, i) => replayer.replay(play, i));
  return collectStatistics(level, terms, replayed, options);
}
