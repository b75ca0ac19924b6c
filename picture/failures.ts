import { drawSquares, type Explored, shadeSigns } from './heat.ts';
import type { LegendEntry } from './legend.ts';
import { drawText } from './text.ts';
import type { Theme } from './theme.ts';
import type { View } from './view.ts';
import { num } from './xml.ts';

/** Where attempts of players fail, for a heat map. */
export interface Failures {
  /** The place of each failure, px of the level. */
  readonly places: readonly { readonly x: number; readonly y: number }[];
  /** Places where many fail; each gets a ring with its number, from 1. */
  readonly clusters: readonly {
    /** The middle, px of the level. */
    readonly x: number;
    /** See `x`, px of the level. */
    readonly y: number;
    /** How far its failures are from the middle, px of the level. */
    readonly spread: number;
    /** What the legend says of it. */
    readonly label: string;
  }[];
}

/** Side of a square, px of the level: the failures in each are counted. */
const CELL = 16;

/** Radius of a ring at least, units of the picture. */
const SMALLEST_RING = 13;

function cellsOf({ places }: Failures): Explored {
  const cells = new Map<string, { x: number; y: number; visits: number }>();
  for (const { x, y } of places) {
    const [column, row] = [Math.floor(x / CELL), Math.floor(y / CELL)];
    const key = `${column} ${row}`;
    const cell = cells.get(key) ?? { x: (column + 0.5) * CELL, y: (row + 0.5) * CELL, visits: 0 };
    cell.visits++;
    cells.set(key, cell);
  }
  return { cellSize: CELL, cells: [...cells.values()] };
}

/** Draws where attempts fail: squares that are darker the more fail there, with a small cross in each. */
export function drawFailures(view: View, theme: Theme, failures: Failures): string {
  const explored = cellsOf(failures);
  const arm = (CELL * view.scale) / 4;
  const stroke = `m${num(-arm)} ${num(-arm)}l${num(2 * arm)} ${num(2 * arm)}m0 ${num(-2 * arm)}l${num(-2 * arm)} ${num(2 * arm)}`;
  const crosses = explored.cells.map(({ x, y }) => `M${num(view.x(x))} ${num(view.y(y))}${stroke}`);
  return (
    `<g data-kind="failures" fill="${theme.bad}">${drawSquares(view, explored)}` +
    `<path d="${crosses.join('')}" fill="none" stroke="${theme.bad}" stroke-width=".8" stroke-opacity=".8"/></g>`
  );
}

/** Draws a ring with its number around each cluster of failures. It is drawn above everything else. */
export function drawFailureRings(view: View, theme: Theme, { clusters }: Failures): string {
  const rings = clusters.map(({ x, y, spread }, i) => {
    const radius = Math.max(SMALLEST_RING, 1.5 * spread * view.scale);
    const label = String(i + 1);
    const [cx, cy] = [view.x(x), view.y(y)];
    const style = { size: 9, color: theme.text, bold: true, anchor: 'middle' } as const;
    return (
      `<circle cx="${num(cx)}" cy="${num(cy)}" r="${num(radius)}" stroke="${theme.halo}" stroke-width="4"/>` +
      `<circle cx="${num(cx)}" cy="${num(cy)}" r="${num(radius)}" stroke="${theme.bad}" stroke-width="1.8"/>` +
      drawText(label, cx, cy - radius - 5, style)
    );
  });
  return rings.length === 0 ? '' : `<g data-kind="failure-rings" fill="none">${rings.join('')}</g>`;
}

/** The entries of the legend: what is counted, the failures of each shade, and each cluster. */
export function failureSigns(theme: Theme, failures: Failures): LegendEntry[] {
  const ring = `<circle r="8" fill="none" stroke="${theme.bad}" stroke-width="1.8"/>`;
  const shades = shadeSigns(theme, theme.bad, cellsOf(failures));
  const clusters = failures.clusters.map(({ label }, i) => ({ label: `${i + 1}: ${label}`, icon: ring }));
  return [{ label: `failures of players in each square of ${CELL} px:`, icon: null }, ...shades, ...clusters];
}
