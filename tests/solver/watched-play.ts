import { type AccuracyName, compile, createSimulation } from '../../engine/index.ts';
import type { Level } from '../../schema/index.ts';

/** A state of a run: hers, as the engine reads it, and the places of the asteroids. */
export interface Look {
  readonly s: readonly number[];
  readonly rocks: readonly number[];
}

/** Whether the button is held in the next tick, given the state at its start. */
export type Player = (look: Look, luck: number) => boolean;

/** Her state and the asteroids' places at each tick while the run goes on. */
export function watch(of: Level, accuracy: AccuracyName, ticks: number, player: Player, luck: () => number): Look[] {
  const simulation = createSimulation(compile(of, accuracy));
  const state = new Float64Array(6);
  const places = new Float64Array(2 * of.asteroids.length);
  const looks: Look[] = [];
  const look = (): Look => {
    simulation.readState(state);
    simulation.readAsteroids(places);
    return { s: [...state], rocks: [...places] };
  };
  looks.push(look());
  for (let tick = 0; tick < ticks; tick++) {
    simulation.advance(1, player(looks[tick], luck()));
    if (simulation.ending !== null) break;
    looks.push(look());
  }
  return looks;
}

/**
 * Holds the button such that she comes to rest as far out as possible, just within the range, and lingers there, on the given
 * sides of the asteroid. From there she comes back no faster than she needs; elsewhere she is turned back at once.
 */
export const lingering =
  (
    pull: number,
    range: number,
    at: (look: Look) => number,
    speed: (look: Look) => number,
    sides: readonly number[],
    within: number,
  ): Player =>
  (look) => {
    const side = Math.sign(at(look));
    const left = range - within - Math.abs(at(look));
    const outwards = speed(look) * side;
    if (!sides.includes(side)) return true;
    if (outwards < 0) return outwards * outwards < 0.4 * pull * range;
    return left < 0 || (outwards * outwards * range) / pull > left * left;
  };
