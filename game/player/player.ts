import { maxTicksOf, type RunEvent, type Scene, type Simulation, TICK, TICK_RATE } from '../../engine/index.ts';
import type { Hold, Level } from '../../schema/basics/index.ts';
import { Body, countCollected, eventPlace } from './body.ts';
import { type Ghost, GhostRun } from './ghost.ts';
import { Gun, type GunCopy, Script } from './gun.ts';
import type { AttemptOptions, PlayEnding, PlayEvent, PlayerOptions } from './options.ts';
import { CHECKPOINT_TICKS, PlayHash, type PlayHashMark } from './play-hash.ts';

/** The longest frame that counts if the options name none, ms. */
const MAX_FRAME = 100;

const MS_PER_TICK = 1000 / TICK_RATE;

/** The rounding of frame times must not delay a tick by a frame; ticks. */
const ROUNDING = 1e-6;

/** A moment of a play; {@link Player.snapshot} makes it, {@link Player.restore} goes back to it. */
export interface PlayerSnapshot {
  /** The tick at which it was made. */
  readonly tick: number;
}

interface Moment extends PlayerSnapshot {
  readonly simulation: Float64Array;
  readonly body: readonly Float64Array[];
  readonly gun: GunCopy;
  readonly hash: PlayHashMark;
  readonly events: readonly RunEvent[];
  readonly ended: PlayEnding | null;
  readonly rest: number;
  readonly script: Script | null;
}

/**
 * A person's attempt at a level. It advances by frames of any length and simulates whole ticks of 1/60 s, so that it gives the
 * same bits on every machine: `simulate(player.scene, player.holds)` repeats the play exactly.
 */
export interface Player {
  /** The level that is played. */
  readonly level: Level;
  /** The level, compiled at the accuracy of the play. */
  readonly scene: Scene;
  /** Ticks simulated since the start. */
  readonly tick: number;
  /** Simulated time since the start, s; when the play has ended, when it ended. */
  readonly time: number;
  /** How the play ended; null while it lasts. */
  readonly ending: PlayEnding | null;
  /** Whether the gun is held in the tick that was last simulated. */
  readonly held: boolean;
  /** The asteroid that the gun pulls her towards: index within the level's asteroids, from 0; or null. */
  readonly target: number | null;
  /** Minerals counted so far, as a play claims them. `arcade` may count one twice, as the original game did. */
  readonly mineralCount: number;
  /** Different minerals collected so far: never more than the level has. What people are shown. */
  readonly collectedCount: number;
  /** Her state after the last tick: x, y (px), vx, vy (px/s), cos, sin. */
  readonly state: Readonly<Float64Array>;
  /** Her state before the last tick. */
  readonly previous: Readonly<Float64Array>;
  /** How far the time that is shown is between `previous` (0) and `state` (1); 1 after the end. */
  readonly alpha: number;
  /** Everything that has happened so far, in order of time. */
  readonly events: readonly RunEvent[];
  /** The holds so far, in ticks. One that lasts ends at the present tick. */
  readonly holds: Hold[];
  /** The runs that are shown beside the play. */
  readonly ghosts: readonly Ghost[];
  /** The hash of the play so far, 16 hexadecimal digits, as a `.gqr` file contains it. */
  readonly hash: string;
  /** The hashes of the play at every multiple of 600 ticks so far. */
  readonly checkpoints: readonly string[];
  /**
   * Advances by the time since the last frame. Whole ticks are simulated; the rest counts in the next frame. A longer frame than
   * `maxFrame` counts as `maxFrame`: after a stall the game is slower rather than ahead.
   *
   * @param ms - milliseconds; nothing happens if it is negative, as clocks sometimes step back
   * @returns the ticks that were simulated
   * @throws {RangeError} when `ms` is not a number; nothing has changed then
   */
  advance(ms: number): number;
  /** Presses the button of the gun: it is held from the next tick on. Pressing twice is pressing once. */
  press(): void;
  /** Releases it. A press and a release between two ticks hold it for one tick. */
  release(): void;
  /**
   * Begins again.
   *
   * @param options - what the new attempt begins with; what is left out stays as it is
   */
  restart(options?: AttemptOptions): void;
  /**
   * Says whether a mineral has been collected.
   *
   * @param mineral - index within the level's minerals, from 0
   * @returns true once she has collected it
   */
  isCollected(mineral: number): boolean;
  /**
   * Writes her state at the time that is shown, between two ticks.
   *
   * @param out - receives x, y (px), vx, vy (px/s), cos, sin
   */
  readPose(out: Float64Array): void;
  /**
   * Writes x, y (px) and alive (1, or 0 once exploded) of every alien at the time that is shown.
   *
   * @param out - receives 3 doubles per alien
   */
  readAliens(out: Float64Array): void;
  /**
   * Writes x, y (px) of every asteroid at the time that is shown. Recoil moves asteroids.
   *
   * @param out - receives 2 doubles per asteroid
   */
  readAsteroids(out: Float64Array): void;
  /**
   * Remembers the present moment.
   *
   * @returns the moment
   */
  snapshot(): PlayerSnapshot;
  /**
   * Goes back to a moment of this player. The play goes on as if nothing had happened since.
   *
   * @param snapshot - what {@link Player.snapshot} gave
   */
  restore(snapshot: PlayerSnapshot): void;
}

/** Creates a simulation of a scene. `events` receives what happens, unless it is null. */
export type CreateSimulation = (scene: Scene, events: RunEvent[] | null) => Simulation;

/** A player of a scene. */
export class LevelPlayer implements Player {
  events: RunEvent[] = [];
  ending: PlayEnding | null = null;
  /** `alpha`, for the ghosts: an array, since a number that is passed on would be allocated in every frame. */
  private readonly shown = new Float64Array(1);
  ghosts: readonly GhostRun[] = [];
  private readonly simulation: Simulation;
  private readonly body: Body;
  private readonly gun = new Gun();
  private readonly playHash: PlayHash;
  private readonly onTick: (() => void) | null;
  private readonly maxTicks: number;
  private readonly maxFrame: number;
  /** Receives the events of a tick. */
  private readonly happened: RunEvent[] = [];
  /** Events that `onEvent` has not been called for, and whether the same is true of the end. */
  private readonly untold: PlayEvent[] = [];
  private isEndUntold = false;
  /** Ticks that have passed but are not simulated, below 1. */
  private rest = 0;
  private script: Script | null = null;
  private attempt: AttemptOptions = {};
  private readonly moments = new WeakSet<PlayerSnapshot>();

  constructor(
    readonly scene: Scene,
    private readonly options: PlayerOptions,
    private readonly create: CreateSimulation,
  ) {
    this.maxTicks = maxTicksOf({ maxTime: options.maxTime ?? scene.terms.maxTime });
    this.onTick = options.onTick ?? null;
    this.maxFrame = options.maxFrame ?? MAX_FRAME;
    this.simulation = create(scene, this.happened);
    this.body = new Body(this.simulation);
    this.playHash = new PlayHash(this.simulation);
    this.restart(options);
  }

  get alpha(): number {
    return this.shown[0];
  }

  get level(): Level {
    return this.scene.level;
  }

  get tick(): number {
    return this.simulation.tick;
  }

  get time(): number {
    return this.ending?.time ?? this.simulation.time;
  }

  get held(): boolean {
    return this.gun.held;
  }

  get target(): number | null {
    return this.simulation.target;
  }

  get mineralCount(): number {
    return this.simulation.mineralCount;
  }

  get collectedCount(): number {
    return countCollected(this.simulation, this.events, this.level.minerals.length);
  }

  get state(): Float64Array {
    return this.body.state;
  }

  get previous(): Float64Array {
    return this.body.previous;
  }

  get holds(): Hold[] {
    return this.gun.holds(this.tick);
  }

  get hash(): string {
    return this.playHash.digest(this.ending?.outcome ?? '');
  }

  get checkpoints(): readonly string[] {
    return this.playHash.checkpoints;
  }

  press(): void {
    if (this.script === null) this.gun.press();
  }

  release(): void {
    if (this.script === null) this.gun.release();
  }

  isCollected(mineral: number): boolean {
    return this.simulation.isCollected(mineral);
  }

  readPose(out: Float64Array): void {
    this.body.readPose(this.alpha, out);
  }

  readAliens(out: Float64Array): void {
    this.body.readAliens(this.alpha, out);
  }

  readAsteroids(out: Float64Array): void {
    this.body.readAsteroids(this.alpha, out);
  }

  advance(ms: number): number {
    if (typeof ms !== 'number' || Number.isNaN(ms)) {
      throw new RangeError(`advance: expected the milliseconds since the last frame, found ${String(ms)}`);
    }
    const from = this.tick;
    if (this.ending === null) {
      this.rest += Math.min(Math.max(0, ms), this.maxFrame) / MS_PER_TICK;
      while (this.rest >= 1 - ROUNDING && this.ending === null) {
        this.rest = Math.max(0, this.rest - 1);
        this.step();
      }
      this.show();
    }
    const ticks = this.tick - from;
    this.tell();
    return ticks;
  }

  /** Shows the time that has passed; after the end, the last state. */
  private show(): void {
    this.shown[0] = this.ending === null ? Math.min(1, this.rest) : 1;
  }

  /** Simulates one tick. */
  private step(): void {
    const { simulation, gun, script, body, happened, playHash } = this;
    // a whole number: a double would be allocated where it is passed on, and its remainder takes longer
    const tick = simulation.tick | 0;
    const held = script === null ? gun.take(tick) : gun.set(tick, script.isHeldAt(tick));
    simulation.advance(1, held);
    body.step();
    for (let i = 0; i < happened.length; i++) {
      const event = happened[i];
      this.events.push(event);
      playHash.event(event);
      if (this.options.onEvent !== undefined) this.untold.push({ event, tick, ...eventPlace(this.level, body, event) });
    }
    if (happened.length > 0) happened.length = 0;
    const now = simulation.tick | 0;
    if (now % CHECKPOINT_TICKS === 0) playHash.tick();
    const { ghosts, onTick } = this;
    for (let i = 0; i < ghosts.length; i++) ghosts[i].follow(now);
    const { ending } = simulation;
    if (ending !== null || now >= this.maxTicks) {
      this.ending = ending ?? { outcome: 'timeout', with: null, time: now * TICK, tick: now };
      this.isEndUntold = true;
    }
    if (onTick !== null) onTick();
  }

  /** Reports what has happened. A callback that throws has been told; the rest waits for the next frame. */
  private tell(): void {
    const { onEvent, onEnd } = this.options;
    while (this.untold.length > 0) onEvent?.(this.untold.shift() as PlayEvent);
    if (!this.isEndUntold || this.ending === null) return;
    this.isEndUntold = false;
    onEnd?.(this.ending);
  }

  restart(options: AttemptOptions = {}): void {
    this.attempt = { ...this.attempt, ...options };
    const { replay = null, from = null, ghosts = [] } = this.attempt;
    this.simulation.reset();
    this.gun.reset();
    this.playHash.reset();
    // a caller may have kept the list of the last attempt
    this.events = [];
    this.happened.length = this.untold.length = 0;
    this.ending = null;
    this.isEndUntold = false;
    this.rest = 0;
    if (options.ghosts !== undefined) {
      this.ghosts = ghosts.map((ghost) => new GhostRun(this.create(this.scene, null), ghost, this.shown));
    } else for (const ghost of this.ghosts) ghost.reset();
    this.script = from === null ? null : new Script(from.holds);
    while (from !== null && this.tick < from.tick && this.ending === null) this.step();
    this.untold.length = 0;
    // nothing before the play begins is shown
    this.body.jump();
    for (const ghost of this.ghosts) ghost.jump();
    this.script = replay === null ? null : new Script(replay);
    this.show();
  }

  snapshot(): PlayerSnapshot {
    const moment: Moment = {
      tick: this.tick,
      simulation: this.simulation.snapshot(),
      body: this.body.copy(),
      gun: this.gun.copy(),
      hash: this.playHash.mark(),
      events: this.events.slice(),
      ended: this.ending,
      rest: this.rest,
      script: this.script,
    };
    this.moments.add(moment);
    return moment;
  }

  restore(snapshot: PlayerSnapshot): void {
    if (!this.moments.has(snapshot)) throw new RangeError('restore: expected a snapshot of this player, found another object');
    const moment = snapshot as Moment;
    this.simulation.restore(moment.simulation);
    this.body.paste(moment.body);
    this.gun.paste(moment.gun);
    this.playHash.return(moment.hash);
    this.events = moment.events.slice();
    this.happened.length = this.untold.length = 0;
    this.ending = moment.ended;
    this.isEndUntold = false;
    this.rest = moment.rest;
    this.show();
    this.script = moment.script;
    for (const ghost of this.ghosts) ghost.follow(moment.tick);
  }
}
