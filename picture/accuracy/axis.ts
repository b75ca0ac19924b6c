/** A logarithmic axis over whole decades. */
export interface LogAxis {
  /** Powers of ten at its ends. */
  readonly low: number;
  readonly high: number;
  /** The position of a value between `from` and `to`; values outside are clamped to the axis. */
  at(value: number): number;
}

/** Creates an axis for all positive values: at least one decade, and a default one when there are none. */
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

/** The powers of ten to label, if there is room for about `room` labels. */
export function decades({ low, high }: LogAxis, room: number): number[] {
  const step = Math.max(1, Math.ceil((high - low) / room));
  const first = Math.ceil(low / step) * step;
  return Array.from({ length: Math.floor((high - first) / step) + 1 }, (_, i) => first + i * step);
}

/** Formats a power of ten: 0.01, 1, 1,000; 1e-6 where that is shorter. */
export function powerOfTen(power: number): string {
  if (power >= 0 && power <= 4) return (10 ** power).toLocaleString('en-US');
  if (power < 0 && power >= -3) return (10 ** power).toFixed(-power);
  return `1e${power}`;
}
