import type { Line } from '../../canvas/index.ts';

/** At most so many dashes in all: a longer line gets longer ones. */
const MOST = 1500;

const lengthOf = (line: Line): number => {
  let length = 0;
  for (let i = 2; i < line.length; i += 2) length += Math.hypot(line[i] - line[i - 2], line[i + 1] - line[i - 1]);
  return length;
};

/**
 * The dashes of lines, each with a gap of its own length after it.
 * @param length of a dash along the line
 * @returns a line for each
 */
export function dashesOf(lines: readonly Line[], length: number): Line[] {
  const all = lines.reduce((sum, line) => sum + lengthOf(line), 0);
  const dash = Math.max(length, all / (2 * MOST));
  return lines.flatMap((line) => dashesOfLine(line, dash));
}

function dashesOfLine(line: Line, dash: number): Line[] {
  if (line.length < 4) return [];
  const dashes: number[][] = [];
  let drawn: number[] | null = [line[0], line[1]];
  let left = dash;
  for (let i = 2; i < line.length; i += 2) {
    let [x, y] = [line[i - 2], line[i - 1]];
    let rest = Math.hypot(line[i] - x, line[i + 1] - y);
    while (rest > left) {
      const share = left / rest;
      x += (line[i] - x) * share;
      y += (line[i + 1] - y) * share;
      rest -= left;
      left = dash;
      if (drawn === null) drawn = [x, y];
      else {
        dashes.push([...drawn, x, y]);
        drawn = null;
      }
    }
    left -= rest;
    drawn?.push(line[i], line[i + 1]);
  }
  if (drawn !== null && drawn.length >= 4) dashes.push(drawn);
  return dashes;
}
