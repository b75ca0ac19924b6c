import { type Simulation, STATE_SIZE } from '../../../engine/index.ts';
import type { Disc, Hold, Place } from '../../../schema/basics/index.ts';
import type { Random } from '../../random.ts';
import type { GeneratorSpec } from './generator-spec.ts';
import { distance, fits, type Layout } from './layout.ts';
import type { Flight } from './themes/index.ts';
import { distanceToWays, type Way } from './tube.ts';

/** A run drawn in a layout without a black hole. */
export interface DrawnFlight {
  readonly holds: readonly Hold[];
  /** Her centre every {@link EVERY} ticks, through the last pause. */
  readonly way: Way;
  /** The first place of the way at which the run may end. */
  readonly from: number;
}

// Ticks between two places.
const EVERY = 4;

// How often a press is drawn anew when it leads out of the level or into something deadly.
const REDRAWS = 6;

// Ticks before the first press, between presses, and after the last release, at least.
const WAIT = 10;
const LAST_PAUSE = 20;

// px between her path and the edge of the level, at least.
const INSIDE = 25;

// px by which a path leaves a straight line, at least: on one every press leads to the same places.
const BENT = 16;

/**
 * Draws a run press by press, and draws a press anew where it leads to an end, so that much of what is drawn can be used.
 * @param simulation the layout without a black hole
 * @returns the run up to the pause after each of its presses, as soon as they are enough; and the ticks simulated
 */
export function drawFlights(
  simulation: Simulation,
  spec: GeneratorSpec,
  random: Random,
): { readonly flights: readonly DrawnFlight[]; readonly ticks: number } {
  const [least, most] = spec.presses;
  const [shortest, longest] = spec.hold;
  const state = new Float64Array(STATE_SIZE);
  let ticks = 0;
  /** Advances to a tick while she stays inside; adds her places. */
  const goTo = (tick: number, held: boolean, way: Place[]): boolean => {
    while (simulation.tick < tick) {
      if (simulation.tick % EVERY === 0) {
        simulation.readState(state);
        const place = { x: state[0], y: state[1] };
        if (!isInside(spec, place)) return false;
        way.push(place);
      }
      ticks += simulation.advance(Math.min(tick - simulation.tick, EVERY - (simulation.tick % EVERY)), held);
      if (simulation.ending !== null) return false;
    }
    return true;
  };

  simulation.reset();
  const holds: Hold[] = [];
  const way: Place[] = [];
  const flights: DrawnFlight[] = [];
  if (!goTo(WAIT, false, way)) return { flights, ticks };
  const before = simulation.snapshot();
  const released = simulation.snapshot();
  for (let presses = most; presses > 0; presses--) {
    simulation.snapshot(before);
    const length = way.length;
    let redraws = 0;
    for (; redraws < REDRAWS; redraws++) {
      const press = simulation.tick + (holds.length === 0 ? random.below(40) : random.below(spec.coast));
      const release = press + shortest + random.below(longest - shortest + 1);
      // she has to survive the shortest pause as well
      if (goTo(press, false, way) && goTo(release, true, way) && goTo(release + WAIT, false, way)) {
        holds.push([press, release]);
        break;
      }
      simulation.restore(before);
      way.length = length;
    }
    if (redraws === REDRAWS) break;
    if (holds.length < least) continue;
    // the run may end in this pause, or go on
    simulation.snapshot(released);
    const from = Math.ceil((holds[holds.length - 1][1] + LAST_PAUSE) / EVERY);
    const whole = [...way];
    goTo(simulation.tick + spec.coast, false, whole);
    if (from < whole.length && isBent(whole)) flights.push({ holds: [...holds], way: whole, from });
    simulation.restore(released);
  }
  return { flights, ticks };
}

const isInside = ({ width, height }: GeneratorSpec, { x, y }: Place): boolean =>
  x > INSIDE && y > INSIDE && x < width - INSIDE && y < height - INSIDE;

function isBent(way: Way): boolean {
  const [start] = way;
  const farthest = way.reduce((a, b) => (distance(b, start) > distance(a, start) ? b : a));
  const length = distance(farthest, start);
  if (length === 0) return false;
  const across = ({ x, y }: Place) => ((farthest.x - start.x) * (y - start.y) - (farthest.y - start.y) * (x - start.x)) / length;
  return way.some((place) => Math.abs(across(place)) >= BENT);
}

// px between the black hole and the start, at least.
const FROM_START = 160;

// px around the place of the black hole that her path must avoid before its end, and before the last release.
const CLEAR_OF_END = 60;
const CLEAR_WHILE_HELD = 45;

const BLACK_HOLE = 18;

// px of the grid of the black hole.
const GRID = 4;

/** A place of a way where the run may end. */
export interface End {
  readonly blackHole: Disc;
  /** The index of the place. */
  readonly at: number;
}

/** Where the black hole may lie along the last pause of a run, so that she reaches it there and not before. */
export function endsOf({ way, from }: DrawnFlight, layout: Layout, spec: GeneratorSpec): End[] {
  const ends: End[] = [];
  for (let at = from; at < way.length; at++) {
    const blackHole = { x: GRID * Math.round(way[at].x / GRID), y: GRID * Math.round(way[at].y / GRID), radius: BLACK_HOLE };
    if (distance(blackHole, layout.start) < FROM_START || !fits(layout, spec, blackHole)) continue;
    // only the last stretch may come near the black hole
    let last = at;
    while (last > 0 && distance(way[last], blackHole) < 2 * CLEAR_OF_END) last--;
    if (distanceToWays([way.slice(0, last)], blackHole) < CLEAR_OF_END) continue;
    if (distanceToWays([way.slice(0, from)], blackHole) < CLEAR_WHILE_HELD) continue;
    ends.push({ blackHole, at });
  }
  return ends;
}

/** The flight up to a place of the way. */
export const flightUpTo = ({ holds, way }: DrawnFlight, at: number): Flight => ({
  places: way.slice(0, at + 1),
  held: Array.from({ length: at + 1 }, (_, i) => holds.some(([press, release]) => i * EVERY >= press && i * EVERY < release)),
});
