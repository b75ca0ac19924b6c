import { joinHolds, type Scene } from '../../engine/index.ts';
import type { Hold } from '../../schema/index.ts';
import {
  createPlayers,
  fitPlayers,
  type Goal,
  type ObservedAttempt,
  PLAYER_EFFORT,
  type PlayerFit,
  type PlayerForecast,
  verifyRun,
} from '../../solver/index.ts';
import type { Attempt, PlayedBy } from './attempt.ts';
import { alignEdges } from './edges.ts';

/** The player model, fitted to plays of a level. */
export interface FittedPlayers {
  /** The parameters and how well they are known. */
  readonly fit: PlayerFit;
  /** What the model expects with these parameters. */
  readonly forecast: PlayerForecast;
}

/**
 * Fits the player model to the presses and releases of plays, compared with a run. Plays of nobody in particular are left out, since
 * nobody knows how much their players have practised.
 * @param scene the compiled level
 * @param holds the run that players are compared with
 * @param plays what the plays turned out to be
 * @param by who made each play, by the index of the play; null if nobody knows
 * @param goal what an attempt has to achieve
 * @param options seed of the forecast, and the limit of an attempt in ticks
 * @returns null where the run misses the goal, or no press or release of a known player can be compared with it
 */
export function fitToPlays(
  scene: Scene,
  holds: readonly Hold[],
  plays: { readonly all: readonly Attempt[] },
  by: readonly (PlayedBy | null)[],
  goal: Goal,
  options: { readonly seed: number; readonly maxTicks: number },
): FittedPlayers | null {
  const aim = verifyRun(scene, holds, goal, options.maxTicks);
  if (aim === null) return null;
  const edges = joinHolds(holds).flat();
  const players = new Map<string, { order: number; observed: ObservedAttempt }[]>();
  for (const attempt of plays.all) {
    const played = by[attempt.play];
    if (played === null) continue;
    const own = players.get(played.player) ?? [];
    players.set(played.player, own);
    own.push({ order: played.order, observed: observe(edges, attempt) });
  }
  const histories = [...players.values()].map((own) => own.sort((a, b) => a.order - b.order).map(({ observed }) => observed));
  const fit = fitPlayers(edges, aim.tick, histories);
  if (fit === null) return null;
  const population = createPlayers(scene, holds, goal, { ...options, parameters: fit.parameters });
  population.advance(PLAYER_EFFORT);
  return { fit, forecast: population.forecast() };
}

/** An attempt as errors of the presses and releases of a run. */
export function observe(edges: readonly number[], attempt: Pick<Attempt, 'edges' | 'tick' | 'cause'>): ObservedAttempt {
  const partners = alignEdges(edges, attempt.edges);
  const shifts = Array.from(partners, (partner, i) => (partner < 0 ? null : attempt.edges[partner] - edges[i]));
  return { shifts, end: attempt.tick, failed: attempt.cause !== null };
}
