import { inOrderOfPlay, isTaken, moveFile } from '../io/index.ts';
import { pathOfNew } from './level-files.ts';
import { nameTaken } from './refusal.ts';

// at most nine digits, so that the numbers are exact
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
 * New names for the files of one folder, so that they sort in the wanted order by their leading numbers. The existing numbers
 * are reassigned, including gaps; if a name has no number or two have the same, the files are numbered from 1.
 * @param wanted the names, without folder and suffix, in the wanted order
 * @returns the new names in the same order; names that already fit stay the same
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
interface Move {
  readonly from: string;
  readonly to: string;
}

/**
 * Orders renamings so that none overwrites a file that still has to move. In a cycle, one file is first moved aside; its
 * temporary name is also a level name, so that the file stays visible if the renaming is interrupted.
 * @param aside returns a free temporary name
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

/**
 * Renames the files of levels: all or none.
 * @param nameOf the path of a level as the user sees it
 * @throws Refusal if a name is taken
 */
export function moveAll(root: string, moves: readonly Move[], nameOf: (id: string) => string): void {
  const pathIn = (id: string): string => pathOfNew(root, '', id);
  const aside = (id: string): string => {
    for (let n = 1; ; n++) if (!isTaken(pathIn(`${id}-moved-${n}`))) return `${id}-moved-${n}`;
  };
  const done: Move[] = [];
  try {
    for (const move of inSafeOrder(moves, aside)) {
      if (!moveFile(pathIn(move.from), pathIn(move.to))) throw nameTaken(nameOf(move.to));
      done.push(move);
    }
  } catch (error) {
    for (const { from, to } of done.reverse()) moveFile(pathIn(to), pathIn(from));
    throw error;
  }
}
