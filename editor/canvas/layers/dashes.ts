import type { Line } from './way-layer.ts';

/**
 * A line in strokes.
 * @param pattern lengths of strokes and gaps in turn, along the line; an even number of them
 * @returns a line for each stroke
 */
export function strokesOf(line: Line, pattern: readonly number[]): Line[] {
  if (line.length < 4) return [];
  const strokes: number[][] = [];
  let drawn: number[] | null = [line[0], line[1]];
  let part = 0;
  let left = pattern[0];
  for (let i = 2; i < line.length; i += 2) {
    let [x, y] = [line[i - 2], line[i - 1]];
    let rest = Math.hypot(line[i] - x, line[i + 1] - y);
    while (rest > left) {
      const share = left / rest;
      x += (line[i] - x) * share;
      y += (line[i + 1] - y) * share;
      rest -= left;
      part = (part + 1) % pattern.length;
      left = pattern[part];
      if (drawn === null) drawn = [x, y];
      else {
        strokes.push([...drawn, x, y]);
        drawn = null;
      }
    }
    left -= rest;
    drawn?.push(line[i], line[i + 1]);
  }
  if (drawn !== null && drawn.length >= 4) strokes.push(drawn);
  return strokes;
}

/** The length of a line. */
export function lengthAlong(line: Line): number {
  let length = 0;
  for (let i = 2; i < line.length; i += 2) length += Math.hypot(line[i] - line[i - 2], line[i + 1] - line[i - 1]);
  return length;
}

/** At most so many dashes in all: a longer line gets longer ones. */
const MOST_DASHES = 1500;

/** Lines in dashes, each with a gap of its own length after it. @param length of a dash along the line */
export function dashesOf(lines: readonly Line[], length: number): Line[] {
  const all = lines.reduce((sum, line) => sum + lengthAlong(line), 0);
  const dash = Math.max(length, all / (2 * MOST_DASHES));
  return lines.flatMap((line) => strokesOf(line, [dash, dash]));
}
