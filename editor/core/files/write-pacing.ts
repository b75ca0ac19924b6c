import type { Timers } from './timers.ts';

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
