import { drawText, textWidth } from '../text.ts';
import { type Ground, type Ink, inked, inkStyle } from '../theme.ts';
import { escapeXml, num } from '../xml.ts';

export type { Ground } from '../theme.ts';

type State = 'kept' | 'other' | 'unproven' | 'impossible';

/** What a picture of a tuning shows. */
interface TuningPicture {
  readonly title: string;
  readonly subtitle: string;
  /** The labels of the columns; empty for a single column. */
  readonly marks: readonly string[];
  /** One row per level, from top to bottom, with as many states as there are labels, or one. */
  readonly rows: readonly { readonly name: string; readonly states: readonly State[] }[];
}

const WIDTH = 960;
const LEFT = 230;
const RIGHT = 936;
const TOP = 108;
const ROW = 20;
const WIDEST_CELL = 20;

/** What a cell of a sweep says, in words. */
export const STATE_WORDS: Readonly<Record<State, string>> = {
  kept: 'its run completes it',
  other: 'another run does',
  unproven: 'unproven',
  impossible: 'proved impossible',
};
const INK_OF: Readonly<Record<State, Ink>> = { kept: 'rk4', other: 'verlet', unproven: 'muted', impossible: 'arcade' };
const STATES = Object.keys(STATE_WORDS) as readonly State[];

/** Draws a state in a cell around a point. Each has its own shape: a full cell, a ring, a dot, a cross. */
function drawCell(state: State, x: number, y: number, width: number): string {
  const half = width / 2;
  const r = Math.min(half, ROW / 2) * 0.55;
  const [cx, cy] = [num(x), num(y)];
  switch (state) {
    case 'kept':
      return `<rect x="${num(x - half + 0.5)}" y="${num(y - ROW / 2 + 2)}" width="${num(width - 1)}" height="${ROW - 4}" rx="1.5" fill="currentColor"/>`;
    case 'other':
      return `<circle cx="${cx}" cy="${cy}" r="${num(r)}" fill="none" stroke="currentColor" stroke-width="2"/>`;
    case 'unproven':
      return `<circle cx="${cx}" cy="${cy}" r="${num(Math.min(1.8, r))}" fill="currentColor"/>`;
    case 'impossible':
      return `<path d="M${num(x - r)} ${num(y - r)}l${num(2 * r)} ${num(2 * r)}m0 ${num(-2 * r)}l${num(-2 * r)} ${num(2 * r)}" fill="none" stroke="currentColor" stroke-width="2"/>`;
  }
}

/**
 * Draws how levels change with the rules, as a standalone SVG document: one row per level, one column per value. The same input
 * gives the same text.
 */
export function drawTuning({ title, subtitle, marks, rows }: TuningPicture, ground: Ground = 'auto'): string {
  const columns = Math.max(1, marks.length);
  const cell = Math.min(WIDEST_CELL, (RIGHT - LEFT) / columns);
  const xOf = (column: number): number => LEFT + (column + 0.5) * cell;
  const yOf = (row: number): number => TOP + (row + 0.5) * ROW;
  const height = TOP + rows.length * ROW + 24;
  const label = { size: 7.5, color: 'currentColor' } as const;

  const cells = STATES.map((state) =>
    inked(
      ground,
      INK_OF[state],
      rows
        .flatMap(({ states }, row) => states.map((s, column) => (s === state ? drawCell(s, xOf(column), yOf(row), cell) : '')))
        .join(''),
    ),
  );
  let at = 24;
  const legend = STATES.map((state) => {
    const sign = inked(ground, INK_OF[state], drawCell(state, at + 7, 80, 14));
    const word = inked(ground, 'text', drawText(STATE_WORDS[state], at + 20, 83, label));
    at += 20 + textWidth(STATE_WORDS[state], label.size) + 26;
    return sign + word;
  });
  // The ends and the middle suffice to read the others.
  const named = [...new Set([0, (marks.length - 1) >> 1, marks.length - 1])].filter((column) => marks[column] !== undefined);
  const scale = named.map((column) => drawText(marks[column], xOf(column), TOP - 5, { ...label, anchor: 'middle' })).join('');
  const names = rows
    .map(({ name }, row) => drawText(name, LEFT - 10, yOf(row) + 3, { ...label, anchor: 'end', maxWidth: LEFT - 34 }))
    .join('');
  const lines = rows.map((_, row) => `<path d="M24 ${num(yOf(row) + ROW / 2)}H${RIGHT}" stroke="currentColor"/>`).join('');
  const parts = [
    inked(ground, 'panel', `<rect width="${WIDTH}" height="${height}" rx="10" fill="currentColor"/>`),
    inked(ground, 'rule', lines),
    inked(ground, 'text', drawText(title, 24, 36, { size: 13, color: 'currentColor', bold: true, maxWidth: WIDTH - 48 }) + names),
    inked(ground, 'muted', drawText(subtitle, 24, 58, { size: 8, color: 'currentColor', maxWidth: WIDTH - 48 }) + scale),
    ...legend,
    ...cells,
  ];
  return (
    `<svg xmlns="http://www.w3.org/2000/svg" width="${WIDTH}" height="${height}" viewBox="0 0 ${WIDTH} ${height}" role="img">` +
    `<title>${escapeXml(title)}</title><desc>${escapeXml(subtitle)}</desc>${inkStyle(ground)}${parts.join('')}</svg>\n`
  );
}
