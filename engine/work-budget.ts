/** Looks at where something is, of which guards are made, that cost about as much as a piece of motion. */
const LOOKS_A_PIECE = 16;

/**
 * Work allowed where nothing else is said, pieces of motion: what a level may cost `gq check`. At a few microseconds each, the check
 * of any valid file ends within 10 s.
 */
export const DEFAULT_MAX_WORK = 400_000;

/** What recordings of runs may take, bytes. */
const DEFAULT_MAX_RECORDED = 128 * 1024 * 1024;

const TOO_MUCH = {
  work: (limit: number) => `more work than ${limit} pieces of motion`,
  memory: (limit: number) => `more memory for recordings than ${limit} bytes`,
  events: (limit: number) => `more than ${limit} events at one instant: the run does not go on`,
};

/** Thrown where a budget of work is used up. Who gave the budget catches it. */
export class WorkLimitReached extends Error {
  constructor(
    /** pieces of motion, bytes, or events at one instant */
    readonly limit: number,
    /** What there was too much of. */
    readonly of: keyof typeof TOO_MUCH,
  ) {
    super(TOO_MUCH[of](limit));
    this.name = 'WorkLimitReached';
  }
}

/**
 * How much work something may take: a run, or all that is done with a level. It is counted in pieces of motion, and what else takes
 * time as so many of them; not in seconds, so that it ends at the same point on every machine. One budget may be shared by several runs,
 * one after the other.
 */
export class WorkBudget {
  /** Looks so far; hot loops add to it themselves and call {@link check} when it is more than `most`. */
  looks = 0;
  readonly most: number;
  private bytes = 0;

  /**
   * @param maxWork pieces of motion
   * @param maxRecorded bytes that recordings may take
   */
  constructor(
    readonly maxWork: number = DEFAULT_MAX_WORK,
    private readonly maxRecorded: number = DEFAULT_MAX_RECORDED,
  ) {
    this.most = maxWork * LOOKS_A_PIECE;
  }

  /** Pieces of motion spent so far, rounded down. */
  get spent(): number {
    return Math.floor(this.looks / LOOKS_A_PIECE);
  }

  /** Whether nothing is left. */
  get isUsedUp(): boolean {
    return this.looks > this.most || this.bytes > this.maxRecorded;
  }

  /**
   * Counts so many looks.
   * @throws WorkLimitReached when that is more than is left
   */
  look(count: number): void {
    this.looks += count;
    if (this.looks > this.most) this.end();
  }

  /** Counts so many pieces of motion. @throws WorkLimitReached */
  piece(count: number): void {
    this.look(LOOKS_A_PIECE * count);
  }

  /** Counts bytes of a recording. @throws WorkLimitReached */
  record(bytes: number): void {
    this.bytes += bytes;
    if (this.bytes > this.maxRecorded) throw new WorkLimitReached(this.maxRecorded, 'memory');
  }

  /** Does something whose recording is soon forgotten: its bytes count while it lasts. */
  lend<T>(work: () => T): T {
    const { bytes } = this;
    try {
      return work();
    } finally {
      this.bytes = bytes;
    }
  }

  /** @throws WorkLimitReached */
  end(): never {
    throw new WorkLimitReached(this.maxWork, 'work');
  }
}

/** A budget without an end. */
export const unlimited = (): WorkBudget => new WorkBudget(Number.POSITIVE_INFINITY, Number.POSITIVE_INFINITY);
