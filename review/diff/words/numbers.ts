/** Smaller differences are not given as a number. */
const SMALLEST = 0.01;

/** A number in at most `digits` decimals, without an exponent where it is readable without, and without a minus zero. */
const rounded = (value: number, digits: number): string => String(Number(value.toFixed(digits)) + 0);

/** A number of a level: two decimals. */
export const numberInWords = (value: number): string => rounded(value, 2);

/** Two different numbers, with as many decimals as show that they differ. */
export function numbersApart(before: number, after: number): readonly [string, string] {
  for (const digits of [2, 4, 6]) {
    const [b, a] = [rounded(before, digits), rounded(after, digits)];
    if (b !== a) return [b, a];
  }
  return [String(before + 0), String(after + 0)];
}

/** A length in px: `12 px`, `0.35 px`, `less than 0.01 px`. */
export function lengthInWords(length: number): string {
  const size = Math.abs(length);
  if (size < SMALLEST) return `less than ${SMALLEST} px`;
  return `${rounded(size, size >= 10 ? 1 : 2)} px`;
}

/** A move: `12 px right and 3 px up`. */
export function moveInWords(dx: number, dy: number): string {
  const isFar = Math.abs(dx) >= SMALLEST || Math.abs(dy) >= SMALLEST;
  if (!isFar) return lengthInWords(0);
  const parts: string[] = [];
  if (Math.abs(dx) >= SMALLEST) parts.push(`${lengthInWords(dx)} ${dx > 0 ? 'right' : 'left'}`);
  if (Math.abs(dy) >= SMALLEST) parts.push(`${lengthInWords(dy)} ${dy > 0 ? 'down' : 'up'}`);
  return parts.join(' and ');
}

/** Numbers of objects, from 1: `3`, `3 and 4`, `1 to 12`, `1 to 3, 7 and 9`; very many are cut. */
export function indicesInWords(indices: readonly number[]): string {
  const ranges: [number, number][] = [];
  for (const index of [...indices].sort((a, b) => a - b)) {
    const last = ranges[ranges.length - 1];
    if (last !== undefined && index === last[1] + 1) last[1] = index;
    else ranges.push([index, index]);
  }
  const words = ranges.flatMap(([from, to]) =>
    to - from < 2 ? Array.from({ length: to - from + 1 }, (_, i) => String(from + i + 1)) : [`${from + 1} to ${to + 1}`],
  );
  if (words.length > MOST_RANGES) return `${words.slice(0, MOST_RANGES).join(', ')} and others`;
  return words.length === 1 ? words[0] : `${words.slice(0, -1).join(', ')} and ${words[words.length - 1]}`;
}

const MOST_RANGES = 8;
