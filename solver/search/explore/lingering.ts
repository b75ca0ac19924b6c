import { createSimulation, type Scene, type Simulation, STATE_SIZE, TICK } from '../../../engine/index.ts';
import type { Reports } from './records.ts';

/** How near to the end of the range she is allowed to turn, px. */
const WITHIN = 0.02;

/** How fast she comes back from there, in parts of the speed of a fall from the end of the range to the centre. */
const TURN_SPEEDS = [0.8, 0.56, 0.4, 0.28, 0.2, 0.14, 0.1];

/** Ticks of one call of {@link Lingering.step}. */
const PIECE = 600;

/** The line through the start and the nearest asteroid. Places on it are px from the start. */
interface Line {
  readonly target: number;
  /** Direction, a unit vector. */
  readonly ux: number;
  readonly uy: number;
  /** Place of the asteroid at first. */
  readonly centre: number;
}

/**
 * Plays in which recoil carries an asteroid as far as possible, so that she comes farther than its range allowed at first.
 *
 * While the gun is held, the asteroid is pulled towards her and she towards it. She is lost beyond the range, but at its end the
 * pull is 0: if she comes to rest just there, she stays for many seconds with the gun held, while the asteroid gains speed towards
 * her. At the end of the range the distance e from it obeys e'' = (pull / range) e + recoil / diameter, whose unstable equilibrium
 * she approaches by pressing at the last possible moment. Then she falls back, is turned around at once behind the centre, and does
 * it again.
 *
 * A search by cells hardly finds these plays: it takes a state for known when place and velocity are, wherever the asteroid is.
 * They are tried where the black hole lies beyond the centre of the asteroid on the line on which she starts, from rest.
 */
export class Lingering {
  /** Ticks simulated so far. */
  ticks = 0;
  /** Plays begun so far. */
  runs = 0;
  private readonly scene: Scene;
  private readonly maxTicks: number;
  private readonly reports: Reports;
  private readonly line: Line;
  private readonly side: number;
  private readonly simulation: Simulation;
  private readonly state = new Float64Array(STATE_SIZE);
  private readonly asteroids: Float64Array;
  private readonly holds: [number, number][] = [];
  private speed = 0;
  private place = 0;

  private constructor(scene: Scene, maxTicks: number, line: Line, side: number, reports: Reports) {
    this.scene = scene;
    this.maxTicks = maxTicks;
    this.line = line;
    this.side = side;
    this.reports = reports;
    this.simulation = createSimulation(scene);
    this.asteroids = new Float64Array(2 * scene.level.asteroids.length);
  }

  /**
   * The plays of a scene; null where they lead nowhere.
   * @param maxTicks the longest play, ticks
   * @param reports receives the plays that end in the black hole
   */
  static of(scene: Scene, maxTicks: number, reports: Reports): Lingering | null {
    const { level, rules, box } = scene;
    const { astronaut, blackHole, range } = level;
    if (!level.recoil || astronaut.vx !== 0 || astronaut.vy !== 0) return null;
    const line = lineOf(scene);
    if (line === null) return null;
    const dx = blackHole.x - astronaut.x;
    const dy = blackHole.y - astronaut.y;
    const reach = blackHole.radius + box.halfDiagonal;
    if (Math.abs(dy * line.ux - dx * line.uy) > reach) return null;
    const seconds = maxTicks * TICK;
    const drift = (rules.recoil * seconds * seconds) / (4 * level.asteroids[line.target].radius);
    const beyond = dx * line.ux + dy * line.uy - line.centre;
    if (Math.abs(beyond) - reach > range + drift) return null;
    return new Lingering(scene, maxTicks, line, beyond < 0 ? -1 : 1, reports);
  }

  /** Simulates a part of a play. Returns false when all have been tried. */
  step(): boolean {
    const { simulation } = this;
    if (simulation.tick === 0) {
      if (this.runs === TURN_SPEEDS.length) return false;
      this.speed = TURN_SPEEDS[this.runs++] * Math.sqrt(this.scene.rules.pull * this.scene.level.range);
      this.holds.length = 0;
      this.place = this.line.centre;
    }
    const until = Math.min(this.maxTicks, simulation.tick + PIECE);
    const before = simulation.tick;
    while (simulation.tick < until && simulation.ending === null) this.advance();
    // counts as work even where she starts in a hazard
    this.ticks += Math.max(1, simulation.tick - before);
    if (simulation.ending === null && simulation.tick < this.maxTicks) return true;
    if (simulation.ending?.outcome === 'completed') {
      const replayed = this.reports.ticks;
      this.reports.addRun(this.holds);
      this.ticks += this.reports.ticks - replayed;
    }
    simulation.reset();
    return true;
  }

  private advance(): void {
    const { simulation, holds } = this;
    const { tick } = simulation;
    const held = this.isHeld();
    const last = holds.at(-1);
    if (held && last !== undefined && last[1] === tick) last[1] = tick + 1;
    else if (held) holds.push([tick, tick + 1]);
    simulation.advance(1, held);
  }

  private isHeld(): boolean {
    const { simulation, state, asteroids, line, side, scene, speed } = this;
    const { ux, uy, target } = line;
    const { x, y } = scene.level.astronaut;
    simulation.readState(state);
    simulation.readAsteroids(asteroids);
    const place = (asteroids[2 * target] - x) * ux + (asteroids[2 * target + 1] - y) * uy;
    const moved = (place - this.place) / TICK;
    this.place = place;
    // positive on the side of the black hole, and outwards
    const out = side * ((state[0] - x) * ux + (state[1] - y) * uy - place);
    const velocity = side * (state[2] * ux + state[3] * uy);
    const outwards = velocity - side * moved;
    if (out > 0 && outwards > 0) return !this.stopsAt(scene.level.range - out - outwards * TICK, outwards);
    return out > 0 ? -velocity < speed : velocity < speed;
  }

  /** Whether she stops before the end of the range, `left` px away, if the gun is held from now on. */
  private stopsAt(left: number, outwards: number): boolean {
    const { level, rules } = this.scene;
    const rate = rules.pull / level.range;
    // the equilibrium lies beyond the end of the range
    const beyond = rules.recoil / (2 * level.asteroids[this.line.target].radius * rate);
    const square = (left + beyond) * (left + beyond) - (outwards * outwards) / rate;
    return left > 0 && square > 0 && Math.sqrt(square) - beyond > WITHIN;
  }
}

function lineOf({ level: { asteroids, astronaut } }: Scene): Line | null {
  let target = -1;
  let centre = Number.POSITIVE_INFINITY;
  for (const [i, { x, y }] of asteroids.entries()) {
    const dx = x - astronaut.x;
    const dy = y - astronaut.y;
    const distance = Math.sqrt(dx * dx + dy * dy);
    if (distance >= centre) continue;
    centre = distance;
    target = i;
  }
  if (target < 0 || centre === 0) return null;
  const { x, y } = asteroids[target];
  return { target, centre, ux: (x - astronaut.x) / centre, uy: (y - astronaut.y) / centre };
}
