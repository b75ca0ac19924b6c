/** A clock with callbacks: the page's, or one that a test controls. */
export interface Timers {
  /** ms, from an arbitrary origin */
  now(): number;
  /** Calls back after `ms`. @returns cancels it */
  after(ms: number, call: () => void): () => void;
}

/** Waits for a promise, but at most `ms`. */
export async function atMost(ms: number, promise: Promise<unknown>, timers: Timers): Promise<void> {
  let cancel = () => {};
  const late = new Promise<void>((resolve) => {
    cancel = timers.after(ms, resolve);
  });
  await Promise.race([promise, late]);
  cancel();
}

/** A call that is made at most once per interval, however often it is requested. */
export interface Throttled {
  /** Requests the call: it is made after a while, unless `now` comes first. */
  soon(): void;
  /** Makes the call now, if it was requested. */
  now(): void;
}

/** @param ms the longest delay of a call */
export function throttled(ms: number, call: () => void, timers: Timers): Throttled {
  let cancel: (() => void) | null = null;
  const now = () => {
    if (cancel === null) return;
    cancel();
    cancel = null;
    call();
  };
  return {
    soon() {
      cancel ??= timers.after(ms, now);
    },
    now,
  };
}

/** The timers of the page. */
export const pageTimers: Timers = {
  now: () => performance.now(),
  after(ms, call) {
    const id = setTimeout(call, ms);
    return () => clearTimeout(id);
  },
};

/** ms after the last change: together with the write, within half a second */
const PAUSE = 200;
/** ms after which changes are written even without a pause */
const LONGEST_PAUSE = 2000;
/** ms between attempts; the last wait repeats */
const BACKOFF = [500, 1000, 2000, 5000, 10_000] as const;

/** When to write: soon after the last change, and at growing intervals while writes fail. */
export class WritePacing {
  /** Failed writes since the last success. */
  private attempts = 0;
  /** When the first unwritten change was made; null: none. */
  private firstUnsaved: number | null = null;
  private take = () => {};

  constructor(
    private readonly timers: Timers,
    private readonly write: () => void,
  ) {}

  /** Whether the last write failed, so that the next one waits. */
  get isRetrying(): boolean {
    return this.attempts > 0;
  }

  /** Notes that there is something to write. */
  noteChange(): void {
    this.firstUnsaved ??= this.timers.now();
  }

  /** Notes that everything is being written or is on disk. */
  noteUnchanged(): void {
    this.firstUnsaved = null;
  }

  /** Resets the count of failed writes. */
  forgetFailures(): void {
    this.attempts = 0;
  }

  /** Starts over, as if the first change was made now. */
  beginAnew(): void {
    this.attempts = 0;
    this.firstUnsaved = this.timers.now();
  }

  /** Writes after a pause in the changes, or without one if changes have gone on for long. */
  writeSoon(): void {
    const { firstUnsaved, timers } = this;
    const left = (firstUnsaved ?? timers.now()) + LONGEST_PAUSE - timers.now();
    this.writeAfter(Math.max(0, Math.min(PAUSE, left)));
  }

  writeNow(): void {
    this.writeAfter(0);
  }

  /** Writes again after a failure. */
  writeLater(): void {
    this.writeAfter(BACKOFF[Math.min(this.attempts++, BACKOFF.length - 1)]);
  }

  /** Cancels the planned write. */
  cancel(): void {
    this.take();
  }

  private writeAfter(wait: number): void {
    this.take();
    this.take = this.timers.after(wait, this.write);
  }
}
