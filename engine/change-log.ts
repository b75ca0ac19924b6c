import type { WorkBudget } from './work-budget.ts';

/** Bytes of one change: its numbers, and the index of its record. */
const bytesOf = (width: number): number => 8 * (width + 1);

/**
 * The history of many records of `width` numbers each, over a sequence of entries. Each entry changes a few records. The log
 * keeps the changes, and now and then all records, so that both memory and the time to reach any entry are in proportion to
 * what changed.
 */
export class ChangeLog {
  private readonly now: Float64Array;
  private readonly whose: number[] = [];
  private readonly values: number[] = [];
  /** Index in `whose` at which the changes of each entry begin. */
  private readonly from: number[] = [];
  private readonly whole: { readonly entry: number; readonly at: number; readonly records: Float64Array }[] = [];
  /** The entry that the array last given to {@link seek} holds. */
  private at = -1;

  /** @param records - the records before the first entry */
  constructor(
    private readonly width: number,
    records: Float64Array,
    private readonly budget: WorkBudget,
  ) {
    this.now = records.slice();
    this.keepWhole();
  }

  /** Begins a new entry. */
  next(): void {
    const { whose, whole, now, width } = this;
    if (width * (whose.length - whole[whole.length - 1].at) > now.length) this.keepWhole();
    this.from.push(whose.length);
  }

  /** Sets record `i` of the current entry to what `source` has from `o` on. */
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

  /** Sets `into`, always the same array, to the records as they are in an entry; they begin at `offset`. */
  seek(entry: number, into: Float64Array, offset = 0): void {
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
      into.set(records, offset);
      next = at;
    } else {
      next = this.at + 1 < from.length ? from[this.at + 1] : whose.length;
    }
    const end = entry + 1 < from.length ? from[entry + 1] : whose.length;
    for (; next < end; next++) for (let k = 0; k < width; k++) into[offset + width * whose[next] + k] = values[width * next + k];
    this.at = entry;
  }
}
