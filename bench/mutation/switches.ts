/** What instrumented sources ask while they run: which mutant is on. */
export interface Switches {
  /** Whether a mutant is on. */
  is(id: number): boolean;
  /** A turn of a loop. */
  turn(): void;
}

/** Thrown out of a loop that takes far more turns than it takes without a mutant. */
export class Endless extends Error {
  constructor() {
    super('a loop takes too long');
  }
}

/** Looks at the clock once in so many turns. */
const TURNS = 4096;

/** The switches of a session, and how it works them. */
export class Board implements Switches {
  /** what `is` was asked for, 1 each */
  readonly #reached = new Uint8Array(1 << 16);
  #on = 0;
  #isCovering = false;
  #turns = 0;
  #deadline = Number.POSITIVE_INFINITY;

  is(id: number): boolean {
    if (this.#isCovering) this.#reached[id] = 1;
    return id === this.#on;
  }

  turn(): void {
    if (++this.#turns % TURNS === 0 && performance.now() > this.#deadline) throw new Endless();
  }

  get isLate(): boolean {
    return performance.now() > this.#deadline;
  }

  /** Puts a mutant on, or none: 0. */
  put(id: number): void {
    this.#on = id;
  }

  /** What was asked for since the last time. */
  takeReached(): number[] {
    const reached = [...this.#reached.keys()].filter((id) => this.#reached[id] === 1);
    this.#reached.fill(0);
    return reached;
  }

  cover(isCovering: boolean): void {
    this.#isCovering = isCovering;
  }

  /** From now on loops may take so long, ms. */
  allow(ms: number): void {
    this.#deadline = performance.now() + ms;
  }
}
