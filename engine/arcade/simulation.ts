import { TICK } from '../constants.ts';
import type { Scene } from '../scene.ts';
import type { Ending, Mode, Simulation, Work } from '../simulation.ts';
import { unlimited, type WorkBudget } from '../work-budget.ts';
import { Encounters } from './encounters.ts';
import { Flight } from './flight.ts';
import {
  BLACK_HOLE,
  COS,
  COUNTED,
  FRAME,
  HELD,
  HELD_FRAMES,
  LOST,
  MOVED,
  OUTCOME,
  SIN,
  TOUCHED,
  VX,
  VY,
  X,
  Y,
} from './layout.ts';
import type { FrameRecorder } from './recording.ts';
import { Surroundings } from './surroundings.ts';
import { World } from './world.ts';

/** Fewer frames than this are not worth a flight. */
const FEW_FRAMES = 3;

/**
 * The original game frame by frame, at 60 Hz, quirks included (accuracy `arcade`): semi-implicit Euler whose checks use the
 * places of the previous frame. Within a frame, velocities come first, then the gun and the checks on the old places (lost,
 * completed, burned: the first counts), then chasers and fields set accelerations, then everything moves.
 *
 * Each frame examines only what is near enough to matter (`neighbourhoods.ts`), or no object at all where all are far
 * (`flight.ts`); the bits are those of examining everything.
 */
export class ArcadeSimulation implements Simulation {
  readonly scene: Scene;
  private readonly s: Float64Array;
  private readonly world: World;
  private readonly surroundings: Surroundings;
  private readonly flight: Flight;
  private readonly encounters: Encounters;
  private readonly hasChasers: boolean;
  /** How many objects end the run by touch, besides the black hole. */
  private readonly hazards: number;

  constructor(
    scene: Scene,
    private readonly recorder: FrameRecorder | null = null,
    budget: WorkBudget = unlimited(),
  ) {
    this.scene = scene;
    this.world = new World(scene, budget);
    this.s = this.world.s;
    this.surroundings = new Surroundings(this.world);
    this.flight = new Flight(this.world, this.surroundings);
    this.encounters = new Encounters(this, this.world, recorder);
    this.hazards = this.world.hazardCount;
    this.hasChasers = this.world.chasers.count > 0;
  }

  get tick(): number {
    return this.s[FRAME];
  }

  get work(): Work {
    const pieces = this.s[FRAME];
    const circles = 1 + this.hazards + this.world.collectableX.length;
    return { pieces, forceEvaluations: this.s[HELD_FRAMES], guards: pieces * circles, roots: 0 };
  }

  get modes(): readonly Mode[] {
    const frames = this.s[FRAME];
    const held = this.s[HELD_FRAMES];
    const all = [
      { name: 'coast', share: (frames - held) / frames },
      { name: 'pull', share: held / frames },
    ];
    return all.filter(({ share }) => share > 0);
  }

  get mineralCount(): number {
    return this.s[COUNTED];
  }

  get time(): number {
    return this.ending?.time ?? this.s[FRAME] * TICK;
  }

  get target(): number | null {
    const { s, scene } = this;
    if (s[HELD] === 0 || s[OUTCOME] !== 0) return null;
    const { places, placesFrom, placesStep, range } = this.world;
    let best = range * range;
    let nearest = -1;
    for (let i = 0; i < scene.targets.count; i++) {
      const dx = places[placesFrom + placesStep * i] - s[X];
      const dy = places[placesFrom + placesStep * i + 1] - s[Y];
      const d2 = dx * dx + dy * dy;
      if (d2 > best || (d2 === best && nearest >= 0)) continue;
      best = d2;
      nearest = i;
    }
    return nearest < 0 ? null : scene.targets.index[nearest];
  }

  get ending(): Ending | null {
    const code = this.s[OUTCOME];
    if (code === 0) return null;
    const tick = this.s[FRAME] - 1;
    const kind = this.world.kindTouched(code);
    return {
      outcome: code === LOST ? 'lost' : code === BLACK_HOLE ? 'completed' : 'collided',
      with: kind === null ? null : { kind, index: this.s[TOUCHED] },
      time: tick * TICK,
      tick,
    };
  }

  reset(): void {
    this.world.reset();
  }

  snapshot(into?: Float64Array): Float64Array {
    return this.world.snapshot(into);
  }

  restore(snapshot: Float64Array): void {
    this.world.restore(snapshot);
  }

  readState(out: Float64Array): void {
    const s = this.s;
    out[0] = s[X];
    out[1] = s[Y];
    out[2] = s[VX];
    out[3] = s[VY];
    out[4] = s[COS];
    out[5] = s[SIN];
  }

  readAliens(out: Float64Array): void {
    this.world.chasers.read(out);
  }

  /** They are not counted here, so any chaser may have stirred. */
  get mayAliensHaveStirred(): boolean {
    return this.hasChasers;
  }

  readAsteroids(out: Float64Array): void {
    const { scene, places, placesFrom, placesStep } = this.world;
    const { targets } = scene;
    for (let i = 0; i < targets.count; i++) {
      const k = 2 * targets.index[i];
      out[k] = places[placesFrom + placesStep * i];
      out[k + 1] = places[placesFrom + placesStep * i + 1];
    }
  }

  isCollected(index: number): boolean {
    return this.s[this.world.collected + index] !== 0;
  }

  advance(ticks: number, held: boolean): number {
    const { s, surroundings, flight, hasChasers, recorder } = this;
    if (s[OUTCOME] !== 0) return 0;
    const { chasers, budget } = this.world;
    const from = s[FRAME];
    const until = from + ticks;
    while (s[FRAME] < until && s[OUTCOME] === 0) {
      const cell = surroundings.here();
      const start = s[FRAME];
      if (hasChasers) chasers.lookAhead(cell);
      if (
        recorder === null &&
        chasers.ahead >= FEW_FRAMES &&
        !this.world.isBusy &&
        surroundings.isAway(cell, chasers.room, held)
      ) {
        const frame = s[FRAME];
        const chased = chasers.moving > 0;
        flight.fly(chased ? Math.min(until, frame + chasers.ahead) : until, held, chased);
        if (chased) chasers.follow(flight.path, frame, s[FRAME] - frame);
      } else {
        const alert = hasChasers && !chasers.rest;
        surroundings.stayIn(cell, alert ? Number.POSITIVE_INFINITY : chasers.room);
        this.encounters.meet(cell, surroundings.bounds, until, held, alert);
        const things = cell.things + (alert ? chasers.count : 0);
        budget.look((s[FRAME] - start) * (3 + things / 8));
      }
      const rivals = surroundings.isOne ? 1 : cell.rivals.length;
      budget.look((s[FRAME] - start) * (1 + (rivals + s[MOVED]) / 8) + chasers.looked / 8);
    }
    const advanced = s[FRAME] - from;
    if (held) s[HELD_FRAMES] += advanced;
    if (ticks > 0) s[HELD] = held ? 1 : 0;
    return advanced;
  }
}
