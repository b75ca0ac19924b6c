import type { WorkBudget } from './work-budget.ts';

/** Bytes that a change takes: its numbers, and whose they are. */
const bytesOf = (width: number): number => 8 * (width + 1);

/**
 * What becomes of many records of `width` numbers over a row of entries, of which each changes a few: changes are kept, and now and
 * then all of them, so that memory and the way to any entry stay in proportion to what changed.
 */
export class ChangeLog {
  private readonly now: Float64Array;
  private readonly whose: number[] = [];
  private readonly values: number[] = [];
  /** Where in `whose` the changes of each entry begin. */
  private readonly from: number[] = [];
  private readonly whole: { readonly entry: number; readonly at: number; readonly records: Float64Array }[] = [];
  /** The entry that the array last given to {@link seek} has. */
  private at = -1;

  /** @param records what they are before the first entry */
  constructor(
    private readonly width: number,
    records: Float64Array,
    private readonly budget: WorkBudget,
  ) {
    this.now = records.slice();
    this.keepWhole();
  }

  /** Begins an entry. */
  next(): void {
    const { whose, whole, now, width } = this;
    if (width * (whose.length - whole[whole.length - 1].at) > now.length) this.keepWhole();
    this.from.push(whose.length);
  }

  /** In the present entry the record `i` is what `source` has from `o` on. */
  set(i: number, source: Float64Array, o: number): void {
    const { now, width, values } = this;
    let same = true;
    for (let k = 0; k < width; k++) same &&= Object.is(now[width * i + k], source[o + k]);
    if (same) return;
    this.whose.push(i);
    for (let k = 0; k < width; k++) {
      now[width * i + k] = source[o + k];
      values.push(source[o + k]);
    }
    this.budget.record(bytesOf(width));
  }

  private keepWhole(): void {
    this.budget.record(8 * this.now.length);
    this.whole.push({ entry: this.from.length, at: this.whose.length, records: this.now.slice() });
  }

  /** Makes of `into`, always the same array, the records as they are in an entry. */
  seek(entry: number, into: Float64Array): void {
    const { whole, whose, values, width, from } = this;
    let low = 0;
    for (let high = whole.length - 1; low < high; ) {
      const middle = (low + high + 1) >> 1;
      if (whole[middle].entry <= entry) low = middle;
      else high = middle - 1;
    }
    const { entry: first, at, records } = whole[low];
    let next: number;
    if (this.at < first || this.at > entry) {
      into.set(records);
      next = at;
    } else {
      next = this.at + 1 < from.length ? from[this.at + 1] : whose.length;
    }
    const end = entry + 1 < from.length ? from[entry + 1] : whose.length;
    for (; next < end; next++) for (let k = 0; k < width; k++) into[width * whose[next] + k] = values[width * next + k];
    this.at = entry;
  }
}
