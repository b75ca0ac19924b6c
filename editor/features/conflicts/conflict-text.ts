import { commonEnds } from '../../../check/runs/index.ts';

/** A line of a comparison: in both texts, only in the old one, or only in the new one. */
interface DiffLine {
  readonly kind: 'same' | 'old' | 'new';
  readonly text: string;
}

/** Longer middle parts are shown as replaced entirely: comparing them costs the product of their lengths. */
const MOST = 1500;

function middleDiff(old: readonly string[], now: readonly string[]): DiffLine[] {
  if (old.length > MOST || now.length > MOST) {
    return [...old.map((text) => ({ kind: 'old' as const, text })), ...now.map((text) => ({ kind: 'new' as const, text }))];
  }
  // shared[i][j]: the number of lines that old from i on and now from j on have in common
  const width = now.length + 1;
  const shared = new Uint16Array((old.length + 1) * width);
  for (let i = old.length - 1; i >= 0; i--) {
    for (let j = now.length - 1; j >= 0; j--) {
      const [below, beside] = [shared[(i + 1) * width + j], shared[i * width + j + 1]];
      shared[i * width + j] = old[i] === now[j] ? shared[(i + 1) * width + j + 1] + 1 : Math.max(below, beside);
    }
  }
  const lines: DiffLine[] = [];
  let [i, j] = [0, 0];
  while (i < old.length || j < now.length) {
    if (i < old.length && j < now.length && old[i] === now[j]) {
      lines.push({ kind: 'same', text: old[i] });
      i++;
      j++;
    } else if (j === now.length || (i < old.length && shared[(i + 1) * width + j] >= shared[i * width + j + 1])) {
      lines.push({ kind: 'old', text: old[i++] });
    } else {
      lines.push({ kind: 'new', text: now[j++] });
    }
  }
  return lines;
}

/** The differences between two texts, line by line. */
export function diffLines(before: string, after: string): DiffLine[] {
  const [old, now] = [before.split('\n'), after.split('\n')];
  const { head: start, tail: end } = commonEnds(old, now, (a, b) => a === b);
  const same = (text: string): DiffLine => ({ kind: 'same', text });
  return [
    ...old.slice(0, start).map(same),
    ...middleDiff(old.slice(start, old.length - end), now.slice(start, now.length - end)),
    ...old.slice(old.length - end).map(same),
  ];
}

/** longer values are cut, in characters */
const LONGEST = 90;

const isPlain = (value: unknown): value is Record<string, unknown> =>
  typeof value === 'object' && value !== null && !Array.isArray(value);

/** A JSON value as one line: `x 665, y 848`, `[150, 435], [480, 510]`. An undefined value is `absent`. */
export function valueInWords(value: unknown): string {
  if (value === undefined) return 'absent';
  const text = isPlain(value)
    ? Object.entries(value)
        .map(([key, inner]) => `${key} ${JSON.stringify(inner)}`)
        .join(', ')
    : Array.isArray(value)
      ? value.length === 0
        ? 'none'
        : value.map((entry) => JSON.stringify(entry)).join(', ')
      : typeof value === 'string'
        ? value
        : JSON.stringify(value);
  return text.length <= LONGEST ? text : `${text.slice(0, LONGEST - 1)}…`;
}
