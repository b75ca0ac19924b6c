import { Hash, type RunEvent, type Simulation, STATE_SIZE } from '../../engine/index.ts';

/** Ticks between two states that are part of the hash of a play. */
export const CHECKPOINT_TICKS = 600;

/** What {@link PlayHash} remembers, to go back to it. */
export interface PlayHashMark {
  readonly hash: Hash;
  readonly checkpoints: number;
}

/**
 * The hash of a play, computed while it lasts. It covers, bit for bit and in this order: every event, the state of everything at
 * every multiple of {@link CHECKPOINT_TICKS} ticks, after the events up to it, and at last the tick, the outcome and the final
 * state. The same holds on the same level at the same accuracy give the same hash in every JavaScript engine.
 */
export class PlayHash {
  private readonly hash = new Hash();
  private readonly last = new Hash();
  private at: string[] = [];
  private readonly state = new Float64Array(STATE_SIZE);
  private readonly aliens: Float64Array;
  private readonly asteroids: Float64Array;

  /** @param simulation - the simulation whose play is hashed; it is only read */
  constructor(private readonly simulation: Simulation) {
    const { level } = simulation.scene;
    this.aliens = new Float64Array(3 * level.aliens.length);
    this.asteroids = new Float64Array(level.recoil ? 2 * level.asteroids.length : 0);
  }

  /** The hashes at the multiples of {@link CHECKPOINT_TICKS} so far: they say in which of these spans two plays differ first. */
  get checkpoints(): readonly string[] {
    return this.at;
  }

  /** Adds an event. Events are added in order, those of a tick before its {@link PlayHash.tick}. */
  event(event: RunEvent): void {
    this.hash.addEvent(event);
  }

  /** Called after every tick, or at least at multiples of {@link CHECKPOINT_TICKS} and at the end. */
  tick(): void {
    const { simulation } = this;
    const { tick } = simulation;
    // a remainder of whole numbers takes much less time than one of doubles
    if ((tick | 0) % CHECKPOINT_TICKS !== 0 || tick === 0 || simulation.ending !== null) return;
    this.addState(this.hash);
    this.at.push(this.hash.digest());
  }

  /**
   * The hash of the play so far, or of the whole play if it has ended.
   * @param outcome - how it ended; '' while it goes on
   */
  digest(outcome: string): string {
    const { last, simulation } = this;
    last.copy(this.hash);
    last.add(simulation.tick);
    last.addText(outcome);
    this.addState(last);
    return last.digest();
  }

  /** Remembers the present, for {@link PlayHash.return}. */
  mark(): PlayHashMark {
    const hash = new Hash();
    hash.copy(this.hash);
    return { hash, checkpoints: this.at.length };
  }

  /** Goes back to what was remembered. */
  return({ hash, checkpoints }: PlayHashMark): void {
    this.hash.copy(hash);
    this.at = this.at.slice(0, checkpoints);
  }

  /** Goes back to the start. */
  reset(): void {
    this.hash.copy(new Hash());
    this.at = [];
  }

  private addState(hash: Hash): void {
    const { simulation, state, aliens, asteroids } = this;
    simulation.readState(state);
    addAll(hash, state);
    if (aliens.length > 0) {
      simulation.readAliens(aliens);
      addAll(hash, aliens);
    }
    if (asteroids.length > 0) {
      simulation.readAsteroids(asteroids);
      addAll(hash, asteroids);
    }
    hash.add(simulation.mineralCount);
  }
}

function addAll(hash: Hash, numbers: Float64Array): void {
  for (let i = 0; i < numbers.length; i++) hash.add(numbers[i]);
}
