import { type Ground, inked } from '../ink.ts';
import { drawText, type TextStyle } from '../text.ts';
import { num } from '../xml.ts';

/** The slack of a press or release: how far it can move alone. */
export interface Edge {
  /** Its name, such as `press 1`. */
  readonly label: string;
  /** Slack, ticks; at most `limit` each. */
  readonly earlier: number;
  readonly later: number;
}

const MS = 1000 / 60;

/** Draws the slack of each press and release as a bar. The smallest window is emphasized. */
export function drawWindows(
  edges: readonly Edge[],
  limit: number,
  { left, right, top, row }: { readonly left: number; readonly right: number; readonly top: number; readonly row: number },
  ground: Ground,
): string {
  const middle = (left + right) / 2;
  const widest = Math.max(4, ...edges.flatMap(({ earlier, later }) => [earlier, later]));
  const scale = (right - left) / 2 / widest;
  const bottom = top + row * edges.length;
  const smallest = Math.min(...edges.map(({ earlier, later }) => earlier + later));
  const write = (text: string, x: number, y: number, style: Partial<TextStyle> = {}): string =>
    drawText(text, x, y, { size: 7.5, color: 'currentColor', ...style });

  let axis = `M${num(middle)} ${top - 4}V${num(bottom + 4)}`;
  let texts = write('how far each can move alone', left - 66, top - 26, { size: 9 });
  texts += write('earlier', left, top - 9) + write('later', right, top - 9, { anchor: 'end' });
  const step = [5, 10, 15, 30].find((s) => widest / s <= 2.5) ?? 30;
  for (let ticks = 0; ticks <= widest; ticks += step) {
    for (const side of ticks === 0 ? [1] : [-1, 1]) {
      const x = middle + side * ticks * scale;
      if (ticks > 0) axis += `M${num(x)} ${top - 4}V${num(bottom + 4)}`;
      texts += write(ticks === 0 ? '0' : String(Math.round(ticks * MS)), x, bottom + 18, { anchor: 'middle' });
    }
  }
  texts += write('ms', right + 14, bottom + 18);
  const tightest = `smallest window: ${Math.round(smallest * MS)} ms`;
  const parts = [inked(ground, 'rule', `<path d="${axis}" stroke="currentColor" fill="none"/>`)];
  for (const [i, { label, earlier, later }] of edges.entries()) {
    const y = top + row * i + row / 2;
    const isSmallest = earlier + later === smallest;
    const thick = Math.min(12, 0.55 * row);
    const from = middle - earlier * scale;
    const width = Math.max(1.5, (earlier + later) * scale);
    const bar = `<rect x="${num(from)}" y="${num(y - thick / 2)}" width="${num(width)}" height="${num(thick)}" rx="2" fill="currentColor"${isSmallest ? '' : ' fill-opacity=".75"'}/>`;
    // A bar that ends at the limit has an arrow, because the slack may be larger.
    const arrows =
      (earlier >= limit ? `<path d="M${num(from - 2)} ${num(y - 5)}l-6 5l6 5Z" fill="currentColor"/>` : '') +
      (later >= limit ? `<path d="M${num(from + width + 2)} ${num(y - 5)}l6 5l-6 5Z" fill="currentColor"/>` : '');
    parts.push(inked(ground, isSmallest ? 'arcade' : 'verlet', bar + arrows));
    parts.push(inked(ground, 'text', write(label, left - 14, y + 3, { anchor: 'end', bold: isSmallest })));
  }
  parts.push(
    inked(ground, 'muted', texts),
    inked(ground, 'arcade', write(tightest, left - 66, bottom + 44, { size: 8.5, bold: true })),
  );
  return parts.join('');
}
