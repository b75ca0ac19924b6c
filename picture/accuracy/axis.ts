/** A logarithmic axis over whole decades. */
export interface LogAxis {
  /** Powers of ten at its ends. */
  readonly low: number;
  readonly high: number;
  /** Place of a value, which is kept within the axis, between `from` and `to`. */
  at(value: number): number;
}

/** The axis that holds all positive values; a decade at least, one of its own where there are none. */
export function logAxis(values: readonly number[], from: number, to: number): LogAxis {
  const logs = values.filter((value) => value > 0 && Number.isFinite(value)).map(Math.log10);
  const low = logs.length === 0 ? -1 : Math.floor(Math.min(...logs) - 0.05);
  const high = logs.length === 0 ? 0 : Math.max(low + 1, Math.ceil(Math.max(...logs) + 0.05));
  return {
    low,
    high,
    at(value) {
      const log = value > 0 ? Math.min(high, Math.max(low, Math.log10(value))) : low;
      return from + ((log - low) / (high - low)) * (to - from);
    },
  };
}

/** Powers of ten on an axis that can be labelled with about `room` labels. */
export function decades({ low, high }: LogAxis, room: number): number[] {
  const step = Math.max(1, Math.ceil((high - low) / room));
  const first = Math.ceil(low / step) * step;
  return Array.from({ length: Math.floor((high - first) / step) + 1 }, (_, i) => first + i * step);
}

/** A power of ten for a person: 0.01, 1, 1,000; 1e-6 where that is shorter. */
export function powerOfTen(power: number): string {
  if (power >= 0 && power <= 4) return (10 ** power).toLocaleString('en-US');
  if (power < 0 && power >= -3) return (10 ** power).toFixed(-power);
  return `1e${power}`;
}
