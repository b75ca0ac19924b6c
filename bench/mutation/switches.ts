/** What instrumented sources ask while they run: which mutant is on. */
export interface Switches {
  /** Whether a mutant is on. */
  is(id: number): boolean;
  /** Counts one iteration of a loop. */
  turn(): void;
}

/** Thrown out of a loop that makes many more iterations than without a mutant. */
export class Endless extends Error {
  constructor() {
    super('a loop takes too long');
  }
}

/** The clock is read once in this many iterations. */
const TURNS = 4096;

/** The switches of a session, and how the session sets them. */
export class Board implements Switches {
  /** 1 for each mutant that `is` was called with. */
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

  /** Switches one mutant on; 0 for none. */
  put(id: number): void {
    this.#on = id;
  }

  /** Returns and clears the mutants that `is` was called with. */
  takeReached(): number[] {
    const reached = [...this.#reached.keys()].filter((id) => this.#reached[id] === 1);
    this.#reached.fill(0);
    return reached;
  }

  cover(isCovering: boolean): void {
    this.#isCovering = isCovering;
  }

  /** Limits the time that loops may take from now on, ms. */
  allow(ms: number): void {
    this.#deadline = performance.now() + ms;
  }
}
