import {
  ACCURACIES,
  type Accuracy,
  boxOverlapsCircle,
  compile,
  createSimulation,
  DEFAULT_BOX,
  TICK_RATE,
} from '../../engine/index.ts';
import { type Level, NO_OBJECTS } from '../../schema/index.ts';

export interface TunnellingOptions {
  /** Frames per second at which contact is tested, Hz. */
  readonly rate: number;
  /** Number of flights, each of which touches the circle. */
  readonly flights: number;
  /** Random numbers in [0, 1). */
  readonly random: () => number;
}

/** How many of the flights' contacts were missed. */
export interface Missed {
  readonly frame: number;
  readonly swept: number;
}

/**
 * Lets her fly straight past a circle at a random angle, offset and phase between two frames, always such that her box touches
 * it. Counts the contacts that a test at frames misses, and those that the engine's swept test misses.
 * @param radius - radius of the circle, px
 * @param speed - her speed, px/s, at most the game's limit
 */
export function missedContacts(radius: number, speed: number, { rate, flights, random }: TunnellingOptions): Missed {
  let frame = 0;
  let swept = 0;
  for (let i = 0; i < flights; i++) {
    const [dx, dy] = direction(random);
    // combined half width of her box and the circle across her path: every smaller offset is a contact
    const across = DEFAULT_BOX.halfWidth * Math.abs(dy) + DEFAULT_BOX.halfHeight * Math.abs(dx) + radius;
    const offset = (2 * random() - 1) * across;
    const along = DEFAULT_BOX.halfDiagonal + radius + 1 + (random() * speed) / rate;
    const x = dx * along - dy * offset;
    const y = dy * along + dx * offset;
    if (!seenAtFrames(x, y, radius, (dx * speed) / rate, (dy * speed) / rate, along)) frame++;
    if (!seenBySweep(x, y, radius, dx * speed, dy * speed, (2 * along) / speed)) swept++;
  }
  return { frame, swept };
}

/** A random unit vector, from points of the disc: sines would differ between engines. */
function direction(random: () => number): readonly [x: number, y: number] {
  for (;;) {
    const x = 2 * random() - 1;
    const y = 2 * random() - 1;
    const d = Math.sqrt(x * x + y * y);
    if (d > 0.1 && d < 1) return [x / d, y / d];
  }
}

function seenAtFrames(x: number, y: number, radius: number, stepX: number, stepY: number, along: number): boolean {
  const frames = Math.ceil((2 * along) / Math.sqrt(stepX * stepX + stepY * stepY));
  for (let k = 0; k <= frames; k++) if (boxOverlapsCircle(DEFAULT_BOX, x - k * stepX, y - k * stepY, 1, 0, radius)) return true;
  return false;
}

const SWEPT: Accuracy = ACCURACIES.precise;

function seenBySweep(x: number, y: number, radius: number, vx: number, vy: number, seconds: number): boolean {
  const level: Level = {
    name: 'Past a nova',
    description: '',
    astronaut: { x: 0, y: 0, vx, vy },
    blackHole: { x: 0, y: 1e6, radius: 1 },
    range: 1e6,
    recoil: false,
    ...NO_OBJECTS,
    asteroids: [{ id: null, x: 1e5, y: 1e5, radius: 1, hot: false }],
    novae: [{ id: null, x, y, radius }],
    runs: [],
  };
  const simulation = createSimulation(compile(level, SWEPT));
  simulation.advance(Math.ceil(seconds * TICK_RATE), false);
  return simulation.ending?.outcome === 'collided';
}
