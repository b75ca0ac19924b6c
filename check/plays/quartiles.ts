/** The middle of a sample and the middles of its halves. */
export interface Quartiles {
  /** How many numbers the sample has. */
  readonly count: number;
  /** A quarter of the numbers are below. */
  readonly low: number;
  /** Half of the numbers are below. */
  readonly median: number;
  /** Three quarters of the numbers are below. */
  readonly high: number;
}

/** Whole numbers, counted: its size grows with the number of different numbers only. */
export class Tally {
  private readonly counts = new Map<number, number>();
  count = 0;

  add(value: number): void {
    this.counts.set(value, (this.counts.get(value) ?? 0) + 1);
    this.count++;
  }

  /**
   * The quartiles, linear between the two numbers that are nearest in rank (definition 7 of R. J. Hyndman and Y. Fan, Sample
   * quantiles in statistical packages, 1996); null if there is no number.
   */
  quartiles(): Quartiles | null {
    if (this.count === 0) return null;
    const sorted = [...this.counts].sort(([a], [b]) => a - b);
    const at = (rank: number): number => {
      let before = 0;
      for (const [value, count] of sorted) {
        before += count;
        if (rank < before) return value;
      }
      return sorted[sorted.length - 1][0];
    };
    const quantile = (part: number): number => {
      const rank = part * (this.count - 1);
      const [below, above] = [at(Math.floor(rank)), at(Math.ceil(rank))];
      return below + (rank - Math.floor(rank)) * (above - below);
    };
    return { count: this.count, low: quantile(0.25), median: quantile(0.5), high: quantile(0.75) };
  }
}
