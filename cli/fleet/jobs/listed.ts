/** With more entries than this, reports for people list only those that fail, and only so many of them. */
const MOST_LISTED = 1000;

/** Collects what a report for people lists of a set: all of a small one; of a large one, those that fail. */
export class Listed<T> {
  private readonly first: T[] = [];
  private readonly failing: T[] = [];
  private count = 0;
  private failed = 0;

  add(item: T, isGood: boolean): void {
    this.count++;
    if (this.first.length <= MOST_LISTED) this.first.push(item);
    if (isGood) return;
    this.failed++;
    if (this.failing.length < MOST_LISTED) this.failing.push(item);
  }

  get isSmall(): boolean {
    return this.count <= MOST_LISTED;
  }

  get items(): readonly T[] {
    return this.isSmall ? this.first : this.failing;
  }

  /** How many that fail are not listed. */
  get unlisted(): number {
    return this.isSmall ? 0 : this.failed - this.failing.length;
  }
}

/** What a report for people says of those that it does not list; '' if there are none. */
export const unlistedInWords = (unlisted: number): string =>
  unlisted === 0 ? '' : `and ${unlisted} more that fail: --format json lists all\n`;
