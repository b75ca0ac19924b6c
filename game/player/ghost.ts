import type { Ending, Simulation } from '../../engine/index.ts';
import { Body } from './body.ts';
import { Script } from './gun.ts';
import type { GhostSource } from './options.ts';

/** A run that is shown beside the play, at the same tick. */
export interface Ghost {
  /** Its name, as it was given. */
  readonly name: string;
  /** Whether its gun is held. */
  readonly held: boolean;
  /** How it ended; null while it goes on. */
  readonly ending: Ending | null;
  /** The asteroid that its gun pulls it towards: index within the level's asteroids, from 0; or null. */
  readonly target: number | null;
  /**
   * Writes its place at the time that is shown.
   *
   * @param out - receives x, y (px), vx, vy (px/s), cos, sin
   */
  readPose(out: Float64Array): void;
}

/** Plays the holds of a ghost beside the play. */
export class GhostRun implements Ghost {
  readonly name: string;
  ending: Ending | null = null;
  private readonly body: Body;
  private readonly script: Script;

  /**
   * @param simulation - at the start of the scene
   * @param shown - how far between two ticks the play is shown, in its only entry
   */
  constructor(
    private readonly simulation: Simulation,
    { name, holds }: GhostSource,
    private readonly shown: Float64Array,
  ) {
    this.name = name;
    this.body = new Body(simulation);
    this.script = new Script(holds);
  }

  get held(): boolean {
    const { tick } = this.simulation;
    return this.ending === null && tick > 0 && this.script.isHeldAt(tick - 1);
  }

  get target(): number | null {
    return this.simulation.target;
  }

  readPose(out: Float64Array): void {
    this.body.readPose(this.ending === null ? this.shown[0] : 1, out);
  }

  /** Follows the player to a tick, from where it is or from the start. */
  follow(tick: number): void {
    const { simulation, body, script } = this;
    if (tick < simulation.tick) this.reset();
    while (simulation.tick < tick && this.ending === null) {
      simulation.advance(1, script.isHeldAt(simulation.tick | 0));
      body.step();
      // a simulation makes its ending anew whenever it is asked
      this.ending = simulation.ending;
    }
  }

  reset(): void {
    this.simulation.reset();
    this.ending = null;
    this.jump();
  }

  /** Shows nothing before the tick where it is. */
  jump(): void {
    this.body.jump();
  }
}
