import { inOrderOfPlay } from './level-files.ts';

// up to nine digits, so that they are numbers without rounding
const NUMBERED = /^(\d{1,9})(?=$|[ ._-])(.*)$/;

interface Name {
  readonly digits: string | null;
  readonly rest: string;
}

function parse(name: string): Name {
  const match = NUMBERED.exec(name);
  return match === null ? { digits: null, rest: `-${name}` } : { digits: match[1], rest: match[2] };
}

/**
 * What the files of one folder are to be called so that they sort as wanted, by the numbers their names begin with. Numbers
 * that are there are dealt out anew, gaps and all; when one is missing or there twice, all are counted from 1.
 * @param wanted the names, without folder and suffix, in the wanted order
 * @returns the new names, in the same order; those of files that may stay as they are unchanged
 */
export function namesInOrder(wanted: readonly string[]): string[] {
  if (wanted.every((name, i) => i === 0 || inOrderOfPlay(wanted[i - 1], name) < 0)) return [...wanted];
  const names = wanted.map(parse);
  const values = names.map(({ digits }) => (digits === null ? Number.NaN : Number(digits)));
  const areUsable = new Set(values).size === values.length && !values.includes(Number.NaN);
  const dealt = areUsable ? values.toSorted((a, b) => a - b) : values.map((_, i) => i + 1);
  const width = Math.max(2, ...dealt.map((n) => String(n).length), ...names.map(({ digits }) => digits?.length ?? 0));
  return names.map(({ rest }, i) => (dealt[i] === values[i] ? wanted[i] : `${String(dealt[i]).padStart(width, '0')}${rest}`));
}

/** One step of a renaming. */
export interface Move {
  readonly from: string;
  readonly to: string;
}

/**
 * Renamings put into an order in which none takes the place of a file that is still there. A ring of them begins by moving one
 * aside, under a name that is itself that of a level, so that it is seen if the renaming is cut short.
 * @param aside a free name for a name
 */
export function inSafeOrder(moves: readonly Move[], aside: (name: string) => string): Move[] {
  const waiting = new Map(moves.filter(({ from, to }) => from !== to).map(({ from, to }) => [from, to]));
  const ordered: Move[] = [];
  while (waiting.size > 0) {
    const before = waiting.size;
    for (const [from, to] of waiting) {
      if (waiting.has(to)) continue;
      ordered.push({ from, to });
      waiting.delete(from);
    }
    if (waiting.size < before) continue;
    const [[from, to]] = waiting;
    const place = aside(from);
    ordered.push({ from, to: place });
    waiting.delete(from);
    waiting.set(place, to);
  }
  return ordered;
}
