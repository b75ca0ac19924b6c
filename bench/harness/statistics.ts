import process from 'node:process';

export interface Spread {
  readonly median: number;
  readonly q1: number;
  readonly q3: number;
}

/** Quartiles by linear interpolation between the closest ranks. */
export function spread(values: readonly number[]): Spread {
  const sorted = [...values].sort((a, b) => a - b);
  const at = (p: number) => {
    const place = p * (sorted.length - 1);
    const low = Math.floor(place);
    const high = Math.min(low + 1, sorted.length - 1);
    return sorted[low] + (place - low) * (sorted[high] - sorted[low]);
  };
  return { median: at(0.5), q1: at(0.25), q3: at(0.75) };
}

export const median = (values: readonly number[]): number => spread(values).median;

export const sum = (values: Iterable<number>): number => {
  let total = 0;
  for (const value of values) total += value;
  return total;
};

export const mean = (values: readonly number[]): number => sum(values) / values.length;

/** The value at a share of the sorted values, rounded down to one of them; undefined of none. */
export const lowerRank = (values: readonly number[], share: number): number | undefined =>
  values.toSorted((a, b) => a - b)[Math.floor(share * (values.length - 1))];

/** The value that so large a share of the values does not exceed; not a number of none. */
export const nearestRank = (values: readonly number[], share: number): number =>
  values.toSorted((a, b) => a - b)[Math.min(values.length - 1, Math.ceil(share * values.length) - 1)] ?? Number.NaN;

/** A clock of this process's processor time: ms since now, whatever else the machine does. */
export function processorClock(): () => number {
  const start = process.cpuUsage();
  return () => {
    const { user, system } = process.cpuUsage(start);
    return (user + system) / 1000;
  };
}

/** Processor time of some work, ms. */
export function processorTime(work: () => void): number {
  const spent = processorClock();
  work();
  return spent();
}
