/** Evaluations of a position, of which guards are made, that cost about as much as one piece of motion. */
const LOOKS_A_PIECE = 16;

/**
 * Default work limit of `gq check` for a level, pieces of motion. One piece takes a few microseconds, so that the check of any
 * valid file ends within 10 s.
 */
export const DEFAULT_MAX_WORK = 400_000;

/** Default limit for recordings of runs, bytes. */
const DEFAULT_MAX_RECORDED = 128 * 1024 * 1024;

const TOO_MUCH = {
  work: (limit: number) => `more work than ${limit} pieces of motion`,
  memory: (limit: number) => `more memory for recordings than ${limit} bytes`,
  events: (limit: number) => `more than ${limit} events at one instant: the run does not go on`,
};

/** Thrown when a {@link WorkBudget} is used up. The code that created the budget should catch it. */
export class WorkLimitReached extends Error {
  /**
   * Makes the error.
   *
   * @param limit - the limit that was reached: pieces of motion, bytes, or events at one instant
   * @param of - what there was too much of
   */
  constructor(
    /** The limit that was reached: pieces of motion, bytes, or events at one instant. */
    readonly limit: number,
    /** What there was too much of. */
    readonly of: keyof typeof TOO_MUCH,
  ) {
    super(TOO_MUCH[of](limit));
    this.name = 'WorkLimitReached';
  }
}

/**
 * A limit on the work of one run, or of everything that is done with a level. Work is counted in pieces of motion, other costs
 * as an equivalent number of pieces. It is not counted in seconds, so a computation stops at the same point on every machine.
 * Several runs may share a budget, one after the other.
 *
 * @example
 * ```ts
 * const budget = new WorkBudget(10_000);
 * const run = simulate(scene, [[12, 96]], { budget });
 * if (run.stopped === 'work-limit') console.log(`undecided after ${run.time} s`);
 * ```
 */
export class WorkBudget {
  /**
   * Looks spent so far; 16 looks count as one piece of motion. Hot loops add to it directly, and call {@link WorkBudget.end}
   * when it exceeds `most`.
   */
  looks = 0;
  /** The limit in looks; lower while only a share may be spent ({@link WorkBudget.within}). */
  most: number;
  private bytes = 0;

  /**
   * Makes a budget of which nothing is spent.
   *
   * @param maxWork - pieces of motion allowed; {@link DEFAULT_MAX_WORK} when left out
   * @param maxRecorded - bytes that recordings may take; 128 MiB when left out
   */
  constructor(
    /** Pieces of motion allowed. */
    readonly maxWork: number = DEFAULT_MAX_WORK,
    private readonly maxRecorded: number = DEFAULT_MAX_RECORDED,
  ) {
    this.most = maxWork * LOOKS_A_PIECE;
  }

  /** Pieces of motion spent so far, rounded down. */
  get spent(): number {
    return Math.floor(this.looks / LOOKS_A_PIECE);
  }

  /** Whether nothing is left, of work or of memory for recordings. */
  get isUsedUp(): boolean {
    return this.looks > this.most || this.bytes > this.maxRecorded;
  }

  /**
   * Spends looks.
   *
   * @param count - how many
   * @throws {@link WorkLimitReached} when that is more than is left
   */
  look(count: number): void {
    this.looks += count;
    if (this.looks > this.most) this.end();
  }

  /**
   * Spends pieces of motion.
   *
   * @param count - how many
   * @throws {@link WorkLimitReached} when that is more than is left
   */
  piece(count: number): void {
    this.look(LOOKS_A_PIECE * count);
  }

  /**
   * Spends bytes of a recording.
   *
   * @param bytes - how many
   * @throws {@link WorkLimitReached} when that is more than is left
   */
  record(bytes: number): void {
    this.bytes += bytes;
    if (this.bytes > this.maxRecorded) throw new WorkLimitReached(this.maxRecorded, 'memory');
  }

  /**
   * Runs a function whose recordings are soon discarded: their bytes are given back when it returns.
   *
   * @param work - the function
   * @returns what the function returns
   */
  lend<T>(work: () => T): T {
    const { bytes } = this;
    try {
      return work();
    } finally {
      this.bytes = bytes;
    }
  }

  /**
   * Runs a function that may spend at most a share of the limit, and no more than is left.
   *
   * @param share - from 0 to 1
   * @param work - the function
   * @returns what the function returns
   */
  within<T>(share: number, work: () => T): T {
    const { most } = this;
    this.most = Math.min(most, this.looks + share * most);
    try {
      return work();
    } finally {
      this.most = most;
    }
  }

  /**
   * Reports that the work is used up.
   *
   * @throws {@link WorkLimitReached} always
   */
  end(): never {
    throw new WorkLimitReached(this.maxWork, 'work');
  }
}

/**
 * A budget without a limit.
 *
 * @returns a new budget
 */
export const unlimited = (): WorkBudget => new WorkBudget(Number.POSITIVE_INFINITY, Number.POSITIVE_INFINITY);
