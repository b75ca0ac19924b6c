import { TICK } from '../../../engine/index.ts';
import type { Level } from '../../../schema/index.ts';
import { type FanGrid, type OrbitGrid, type PipeGrid, type Proof, proofPicture } from '../../../solver/index.ts';
import { isEasyFor, recoilBlur } from '../../../solver/prove/assumptions.ts';
import { followBoxes } from '../../../solver/prove/boxes.ts';
import { startAxis } from '../../../solver/prove/doomed.ts';
import { mayFlow } from '../../../solver/prove/flowpipe.ts';
import { followOrbits } from '../../../solver/prove/orbits/index.ts';
import { NUMBERS } from '../../../solver/prove/orbits/layer.ts';
import { DIRECTIONS, followPipes, type Pipe } from '../../../solver/prove/pipe.ts';
import { settingOf, thingOf } from '../../../solver/prove/setting.ts';
import type { Moment } from './moments.ts';

/** Sets that a prover computed, one after the other, each of which is to contain every state of play at its tick. */
export interface Sets {
  /** Ticks from one set to the next. */
  readonly frames: number;
  /** Whether a state lies in each of the sets. Where every run has ended, the last contains nothing. */
  readonly contain: readonly ((now: Moment) => boolean)[];
  /** Whether every run has ended and none came near the object, so that the prover would have a proof. */
  readonly closed: boolean;
}

const HOLE = { kind: 'blackHole' } as const;
const MAX_TIME = 60;

/** Rounding of the engine and of what is computed here, px and px/s. */
const ROUNDING = 1e-7;

/** The boxes of `doomed`; null where she may reach the speed limit at once, so that they say nothing. */
export function fanSets(level: Level, sizes: Omit<FanGrid, 'axis'>, boxes: number): Sets | null {
  const setting = settingOf(level, MAX_TIME, true);
  const strongest = setting.strongest + recoilBlur(setting);
  if (!isEasyFor({ ...setting, strongest }, sizes.frames * TICK)) return null;
  const grid: FanGrid = { ...sizes, axis: startAxis(setting) };
  const steps = Math.floor(8 / (grid.frames * TICK));
  const { layers, closed } = followBoxes(setting, HOLE, thingOf(level, level.blackHole), grid, { steps, boxes });
  const [ux, uy] = grid.axis;
  const { x, y } = level.astronaut;
  const along = (dx: number, dy: number) => [dx * ux + dy * uy, dy * ux - dx * uy];
  const contain = layers.map((layer) => (now: Moment) => {
    const numbers = [...along(now.x - x, now.y - y), ...along(now.vx, now.vy)];
    const slack = ROUNDING + (Number.EPSILON / TICK) * (Math.abs(x) + Math.abs(y));
    return layer.some((box) => numbers.every((v, k) => box[2 * k] - slack <= v && v <= box[2 * k + 1] + slack));
  });
  return { frames: grid.frames, contain: closed ? [...contain, () => false] : contain, closed };
}

/**
 * The boxes of `orbits`; null where it does not apply. States whose asteroids have an unknown velocity are taken for contained as
 * long as there are boxes.
 */
export function orbitSets(level: Level, grid: OrbitGrid, boxes: number): Sets | null {
  const contain: Sets['contain'][number][] = [];
  const layer = (of: { size: number; charts: Int32Array; boxes: Float64Array }) => {
    const charts = of.charts.slice(0, of.size);
    const bounds = of.boxes.slice(0, of.size * NUMBERS);
    contain.push((now) => {
      const { speeds } = now;
      if (speeds === null) return charts.length > 0;
      const states = level.asteroids.flatMap((_, i) => aboutAsteroid(now, speeds, i));
      return charts.some((chart, b) => {
        const { numbers, blur } = states[chart];
        return numbers.every(
          (v, k) => bounds[b * NUMBERS + 2 * k] - blur[k] <= v && v <= bounds[b * NUMBERS + 2 * k + 1] + blur[k],
        );
      });
    });
  };
  const most = { steps: Math.ceil(20 / (grid.frames * TICK)), boxes };
  const { closed } = followOrbits(settingOf(level, MAX_TIME, false), HOLE, thingOf(level, level.blackHole), grid, most, {
    layer,
  });
  return contain.length === 0 ? null : { frames: grid.frames, contain, closed };
}

/** The numbers of a state in the polar and in the Cartesian chart of an asteroid, and how far rounding may have moved them. */
function aboutAsteroid(now: Moment, speeds: Float64Array, i: number) {
  const x = now.x - now.rocks[2 * i];
  const y = now.y - now.rocks[2 * i + 1];
  const vx = now.vx - speeds[2 * i];
  const vy = now.vy - speeds[2 * i + 1];
  const d = Math.hypot(x, y);
  const v = Math.hypot(vx, vy);
  const direction = (Math.atan2(y, x) + 2 * Math.PI) % (2 * Math.PI);
  // places are rounded where they lie, and the velocities of asteroids follow from two of them
  const place = Number.EPSILON * (1 + Math.abs(now.x) + Math.abs(now.y));
  const speed = (2 * place) / TICK;
  const rest = [x * vy - y * vx, (vx * vx + vy * vy) / 2];
  const ofRest = [place * v + speed * d, speed * v];
  return [
    {
      numbers: [d, direction, (x * vx + y * vy) / d, 0, ...rest],
      blur: [place, place / d, speed + (place * v) / d, 0, ...ofRest],
    },
    { numbers: [x, y, vx, vy, ...rest], blur: [place, place, speed, speed, ...ofRest] },
  ];
}

/** The drift places of `flowpipe`, with the angle of her box and the aliens; null where it does not apply. */
export function pipeSets(level: Level, sizes: Omit<PipeGrid, 'axis'>, most: { sets: number; parts: number }): Sets | null {
  const setting = settingOf(level, MAX_TIME, false);
  if (!mayFlow(setting, 0)) return null;
  const grid: PipeGrid = { ...sizes, axis: startAxis(setting) };
  const contain: Sets['contain'][number][] = [];
  const watch = (pipes: readonly Pipe[], step: number) => {
    const copies = pipes.map((pipe) => ({ ...pipe, far: pipe.far.slice() }));
    contain.push((now) => copies.some((pipe) => isInPipe(level, grid, pipe, step, now)));
  };
  const { closed } = followPipes(setting, HOLE, thingOf(level, level.blackHole), grid, most, watch);
  return { frames: grid.frames, contain, closed };
}

function isInPipe({ astronaut }: Level, grid: PipeGrid, { far, turn, aliens }: Pipe, step: number, now: Moment): boolean {
  const [ux, uy] = grid.axis;
  const along = (x: number, y: number) => ({ x: x * ux + y * uy, y: y * ux - x * uy });
  const place = along(now.x - astronaut.x, now.y - astronaut.y);
  const v = along(now.vx, now.vy);
  for (let moment = step; moment <= grid.steps; moment++) {
    const seconds = (moment - step) * grid.frames * TICK;
    const x = place.x + v.x * seconds;
    const y = place.y + v.y * seconds;
    if (DIRECTIONS.some(([dx, dy], m) => x * dx + y * dy > far[moment * DIRECTIONS.length + m] + ROUNDING)) return false;
  }
  const axis = along(now.cos, now.sin);
  const off = Math.min(Math.hypot(axis.x - turn.x, axis.y - turn.y), Math.hypot(axis.x + turn.x, axis.y + turn.y));
  if (off > turn.chord + ROUNDING) return false;
  return aliens.every((alien, i) => {
    if (now.aliens[3 * i + 2] === 0) return alien.doubtful;
    const at = along(now.aliens[3 * i] - astronaut.x, now.aliens[3 * i + 1] - astronaut.y);
    return Math.hypot(at.x - alien.x, at.y - alien.y) <= alien.r + ROUNDING;
  });
}

/** The first tick at which a state of a run does not lie in the set of that tick; null when there is none. */
export function firstOutside({ frames, contain }: Sets, moments: readonly Moment[]): Moment | null {
  for (let n = 0; n < contain.length && n * frames < moments.length; n++) {
    const now = moments[n * frames];
    if (!contain[n](now)) return now;
  }
  return null;
}

/**
 * Whether a state lies where a proof says that she stays: on the near side of its barrier, in range of a listed asteroid, on the
 * stretch of its line or in the places of its dead ends. Null for proofs that say nothing of that kind.
 */
export function staysWithin(level: Level, proof: Proof, isFrames: boolean): ((now: Moment) => boolean) | null {
  const { certificate } = proof;
  switch (certificate.kind) {
    case 'enclosed': {
      const { barrier } = certificate;
      const isStartInside = isInside(barrier, level.astronaut);
      return (now) => isInside(barrier, now) === isStartInside;
    }
    case 'out-of-range': {
      const { asteroids } = certificate;
      return (now) => {
        const far = level.asteroids.map((_, i) => Math.hypot(now.x - now.rocks[2 * i], now.y - now.rocks[2 * i + 1]));
        const nearest = far.indexOf(Math.min(...far));
        // in frames it is noticed a frame later that she is out of range
        return asteroids.includes(nearest) || far[nearest] > level.range;
      };
    }
    case 'line-trap': {
      const setting = settingOf(level, proof.maxTime, isFrames);
      const { x, y } = level.astronaut;
      const target = level.asteroids[certificate.target];
      const centre = Math.hypot(target.x - x, target.y - y);
      const [ux, uy] = [(target.x - x) / centre, (target.y - y) / centre];
      const { back, front } = certificate;
      const pieces = proofPicture(level, proof).lines.filter(({ role }) => role === 'reach');
      return (now) => {
        const along = (now.x - x) * ux + (now.y - y) * uy;
        const aside = (now.y - y) * ux - (now.x - x) * uy;
        const isOn = along > back.at - ON_LINE && along < front.at + setting.jump + ON_LINE && Math.abs(aside) < ON_LINE;
        return isOn || pieces.some(({ points }) => isInConvex(points, now, ON_LINE));
      };
    }
    default:
      return null;
  }
}

/** How far from the exact line she may be, and how far beyond an end before she is stopped there, px. */
const ON_LINE = 0.02;

interface Place {
  readonly x: number;
  readonly y: number;
}

/** Whether a place lies inside a closed line. */
function isInside(corners: readonly Place[], { x, y }: Place): boolean {
  let inside = false;
  for (const [n, a] of corners.entries()) {
    const b = corners[(n + 1) % corners.length];
    if (a.y > y !== b.y > y && x < a.x + ((y - a.y) / (b.y - a.y)) * (b.x - a.x)) inside = !inside;
  }
  return inside;
}

/** Whether a place lies in a convex polygon, or nearer to it than some px. */
function isInConvex(corners: readonly Place[], { x, y }: Place, slack: number): boolean {
  const sides = corners.map((a, n) => {
    const b = corners[(n + 1) % corners.length];
    return ((b.x - a.x) * (y - a.y) - (b.y - a.y) * (x - a.x)) / (Math.hypot(b.x - a.x, b.y - a.y) || 1);
  });
  return sides.every((side) => side > -slack) || sides.every((side) => side < slack);
}
