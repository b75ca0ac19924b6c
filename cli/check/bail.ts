import type { CheckedLevel } from './checked-level.ts';

/** When to stop before all levels are checked. */
export interface Bail {
  /** The number of failing levels after which no other is checked. */
  readonly most: number;
  /** Whether a level fails. */
  readonly fails: (level: CheckedLevel) => boolean;
}

/**
 * Counts failing levels in the order of their files, whatever the order in which they are checked. So the same levels are reported
 * for any number of threads.
 */
export class FailureCount {
  private readonly levels: (CheckedLevel | undefined)[] = [];
  private next = 0;
  private failing = 0;

  constructor(private readonly bail: Bail | null) {}

  /** Whether enough levels have failed, without a gap before them. */
  get isEnough(): boolean {
    return this.bail !== null && this.failing >= this.bail.most;
  }

  /** Adds the results of files that follow one another. @param first the index of the first of them */
  add(first: number, levels: readonly CheckedLevel[]): void {
    if (this.bail === null) return;
    for (const [i, level] of levels.entries()) this.levels[first + i] = level;
    for (let level = this.levels[this.next]; level !== undefined && !this.isEnough; level = this.levels[++this.next])
      if (this.bail.fails(level)) this.failing++;
  }
}

/** The levels up to the last one that may fail. */
export function cutAtBail(levels: readonly CheckedLevel[], bail: Bail | null): CheckedLevel[] {
  if (bail === null) return [...levels];
  let failing = 0;
  const last = levels.findIndex((level) => bail.fails(level) && ++failing >= bail.most);
  return last < 0 ? [...levels] : levels.slice(0, last + 1);
}
