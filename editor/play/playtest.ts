import type { RunEnd } from '../../check/words/index.ts';
import {
  createSimulation,
  DEFAULT_MAX_TIME,
  joinHolds,
  playScript,
  type Scene,
  type Simulation,
  STATE_SIZE,
  TICK,
  TICK_RATE,
} from '../../engine/index.ts';
import type { Hold } from '../../schema/index.ts';
import type { Pose } from '../context/index.ts';

/** `gq simulate` reports a timeout after this many ticks */
export const MAX_TICKS = Math.round(DEFAULT_MAX_TIME * TICK_RATE);

/** longest frame in s that counts; a longer one means that the tab slept or a debugger stopped it, and she waits */
const LONGEST_FRAME = 0.25;

/** A person's attempt: the engine advances tick by tick with the button as it is at each tick. */
export interface Playtest {
  readonly tick: number;
  /** The tick at which the user takes over; before it the run's own holds are played. */
  readonly startTick: number;
  /** null while the attempt lasts */
  readonly end: RunEnd | null;
  readonly held: boolean;
  readonly minerals: number;
  /** px/s */
  readonly speed: number;
  /** The holds played so far: `gq simulate` with them at the same accuracy gives the same bits. */
  holds(): Hold[];
  /** x, y at every tick so far, px */
  points(): Float32Array;
  /**
   * Advances by a span of time: whole ticks are simulated, the rest is kept for the next call.
   * @param seconds of simulated time
   * @param held whether the gun is held in the ticks of this span
   */
  advance(seconds: number, held: boolean): void;
  /** The positions now, which may be between two ticks. */
  pose(): Pose;
}

/** Where she is a fraction of a tick later: in so short a time she flies straight to within 0.01 px. */
function ahead(state: Float64Array, seconds: number): { x: number; y: number } {
  return { x: state[0] + state[2] * seconds, y: state[1] + state[3] * seconds };
}

class PlayedRun implements Playtest {
  end: RunEnd | null = null;
  held = false;
  private readonly simulation: Simulation;
  private readonly played: [number, number][] = [];
  private readonly track: number[] = [];
  private readonly state = new Float64Array(STATE_SIZE);
  private readonly aliens: Float64Array | null;
  private readonly asteroids: Float64Array | null;
  private readonly collected = new Set<number>();
  private rest = 0;

  constructor(
    private readonly scene: Scene,
    private readonly before: readonly Hold[],
    readonly startTick: number,
  ) {
    const { level } = scene;
    this.simulation = createSimulation(scene);
    this.aliens = level.aliens.length > 0 ? new Float64Array(3 * level.aliens.length) : null;
    this.asteroids = level.recoil ? new Float64Array(2 * level.asteroids.length) : null;
    this.look();
    for (let tick = 1; tick <= startTick && this.simulation.ending === null; tick++) {
      playScript(this.simulation, before, tick);
      this.look();
    }
    this.settle();
  }

  get tick(): number {
    return this.simulation.tick;
  }

  get minerals(): number {
    return this.collected.size;
  }

  get speed(): number {
    return Math.hypot(this.state[2], this.state[3]);
  }

  holds(): Hold[] {
    return joinHolds([...this.before, ...this.played]);
  }

  points(): Float32Array {
    return Float32Array.from(this.track);
  }

  advance(seconds: number, held: boolean): void {
    if (this.end !== null) return;
    this.held = held;
    this.rest += Math.min(seconds, LONGEST_FRAME);
    while (this.rest >= TICK && this.end === null) {
      this.rest -= TICK;
      if (held) this.press();
      this.simulation.advance(1, held);
      this.look();
      this.settle();
    }
  }

  pose(): Pose {
    const { level } = this.scene;
    const seconds = this.end === null ? this.rest : 0;
    const { x, y } = ahead(this.state, seconds);
    let beamTo: { x: number; y: number } | null = null;
    if (this.held && this.end === null) {
      let least = Number.POSITIVE_INFINITY;
      for (let i = 0; i < level.asteroids.length; i++) {
        const ax = this.asteroids === null ? level.asteroids[i].x : this.asteroids[2 * i];
        const ay = this.asteroids === null ? level.asteroids[i].y : this.asteroids[2 * i + 1];
        const distance = Math.hypot(ax - x, ay - y);
        if (distance >= least) continue;
        least = distance;
        beamTo = { x: ax, y: ay };
      }
    }
    const { aliens, asteroids, collected } = this;
    return { x, y, cos: this.state[4], sin: this.state[5], beamTo, aliens, asteroids, collected };
  }

  /** Records that the next tick is a held one. */
  private press(): void {
    const tick = this.simulation.tick;
    const last = this.played[this.played.length - 1];
    if (last !== undefined && last[1] === tick) last[1] = tick + 1;
    else this.played.push([tick, tick + 1]);
  }

  private look(): void {
    this.simulation.readState(this.state);
    this.track.push(this.state[0], this.state[1]);
    if (this.aliens !== null) this.simulation.readAliens(this.aliens);
    if (this.asteroids !== null) this.simulation.readAsteroids(this.asteroids);
    for (let i = 0; i < this.scene.level.minerals.length; i++) if (this.simulation.isCollected(i)) this.collected.add(i);
  }

  private settle(): void {
    const { ending, tick } = this.simulation;
    if (ending !== null) this.end = ending;
    else if (tick >= MAX_TICKS) this.end = { outcome: 'timeout', with: null, time: tick * TICK, tick };
  }
}

/**
 * Starts an attempt.
 * @param from the run whose beginning is played first, and the tick at which the user takes over; null: from the start
 */
export function createPlaytest(scene: Scene, from: { readonly holds: readonly Hold[]; readonly tick: number } | null): Playtest {
  if (from === null) return new PlayedRun(scene, [], 0);
  const tick = Math.round(Math.max(0, Math.min(MAX_TICKS, from.tick)));
  const before = joinHolds(from.holds).flatMap(([press, release]): Hold[] =>
    press >= tick ? [] : [[press, Math.min(release, tick)]],
  );
  return new PlayedRun(scene, before, tick);
}
