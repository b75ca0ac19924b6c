import type { Timers } from './timers.ts';

/** After the last change, ms: in time for half a second with the write itself. */
const PAUSE = 200;
/** Changes without a pause are written after so long, ms. */
const LONGEST_PAUSE = 2000;
/** Waits between attempts, ms; the last is repeated. */
const BACKOFF = [500, 1000, 2000, 5000, 10_000] as const;

/** When to write: soon after the last change, and less and less often while nobody takes it. */
export class WritePacing {
  /** Writes that failed since one succeeded. */
  private attempts = 0;
  /** When the first change was made that is not written; null: none. */
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

  /** Something is to be written from now on at the latest. */
  noteChange(): void {
    this.firstUnsaved ??= this.timers.now();
  }

  /** All that was changed is being written, or is on the disk. */
  noteUnchanged(): void {
    this.firstUnsaved = null;
  }

  /** Failed writes no longer count. */
  forgetFailures(): void {
    this.attempts = 0;
  }

  /** What is to be written was asked for just now, and has not failed yet. */
  beginAnew(): void {
    this.attempts = 0;
    this.firstUnsaved = this.timers.now();
  }

  /** Writes after a pause, or without one where changes have gone on for long. */
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

  /** Writes nothing by itself any more, until it is asked again. */
  cancel(): void {
    this.take();
  }

  private writeAfter(wait: number): void {
    this.take();
    this.take = this.timers.after(wait, this.write);
  }
}
