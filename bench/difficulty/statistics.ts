import { mean } from '../harness/index.ts';

/** Pearson's correlation of two lists of numbers. */
export function correlation(a: readonly number[], b: readonly number[]): number {
  const [meanA, meanB] = [mean(a), mean(b)];
  let [ab, aa, bb] = [0, 0, 0];
  for (let i = 0; i < a.length; i++) {
    ab += (a[i] - meanA) * (b[i] - meanB);
    aa += (a[i] - meanA) ** 2;
    bb += (b[i] - meanB) ** 2;
  }
  return ab / Math.sqrt(aa * bb);
}

/** The reliability of a measure of twice the length (C. Spearman, W. Brown, 1910), from the correlation of its halves. */
export const spearmanBrown = (r: number): number => (2 * r) / (1 + r);

/** Counts how often something holds. */
export class Share {
  held = 0;
  tried = 0;

  add(holds: boolean): void {
    this.tried++;
    if (holds) this.held++;
  }

  addAll({ held, tried }: Share): void {
    this.held += held;
    this.tried += tried;
  }

  get share(): number {
    return this.held / this.tried;
  }
}
