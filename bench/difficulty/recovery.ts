import { observe } from '../../check/plays/index.ts';
import { joinHolds, type Scene } from '../../engine/index.ts';
import type { Hold } from '../../schema/index.ts';
import { fitPlayers, type PlayerFit, type PlayerParameters, playAsPlayers, UNCALIBRATED, verifyRun } from '../../solver/index.ts';
import { ANY } from './levels.ts';
import type { Share } from './statistics.ts';

/** Whether the intervals of fitted parameters contain the parameters with which the plays were made. */
export interface Recovery {
  readonly scale: Share;
  readonly learning: Share;
  readonly spread: Share;
}

/** Players of each simulated study, and their attempts. */
const PLAYERS = 12;
const ATTEMPTS = 5;

/** What the plays are made with. */
const TRUTHS: readonly Pick<PlayerParameters, 'scale' | 'learning' | 'spread'>[] = [
  { scale: 1, learning: 0.4, spread: 0.3 },
  { scale: 1.6, learning: 0.2, spread: 0.4 },
  { scale: 0.7, learning: 0.6, spread: 0.2 },
];

/** Lets synthetic players play, and fits the model to what they did. */
export function fitSynthetic(scene: Scene, holds: readonly Hold[], parameters: PlayerParameters, seed: number): PlayerFit | null {
  const aim = verifyRun(scene, holds, ANY);
  if (aim === null) throw new Error('the run misses the goal');
  const edges = joinHolds(holds).flat();
  const players = playAsPlayers(scene, holds, ANY, PLAYERS, { parameters, attempts: ATTEMPTS, seed });
  const observed = players.map((attempts) =>
    attempts.map(({ holds: own, end, succeeds }) =>
      observe(edges, {
        edges: own.flat().filter((edge) => edge < end),
        tick: end,
        cause: succeeds ? null : { kind: 'lost', index: null },
      }),
    ),
  );
  return fitPlayers(edges, aim.tick, observed);
}

/**
 * Fits `studies` sets of plays for each of the known parameters.
 * @param seed another one for each level, so that their luck differs
 */
export function measureRecovery(scene: Scene, holds: readonly Hold[], studies: number, seed: number, recovery: Recovery): void {
  for (const [t, truth] of TRUTHS.entries()) {
    for (let study = 0; study < studies; study++) {
      const fit = fitSynthetic(scene, holds, { ...UNCALIBRATED, ...truth }, seed + t * studies + study);
      if (fit === null) continue;
      for (const key of ['scale', 'learning', 'spread'] as const) {
        const interval = fit[key];
        if (interval !== null) recovery[key].add(interval.low <= truth[key] && truth[key] <= interval.high);
      }
    }
  }
}
