import { boxOf } from '../../engine/index.ts';
import { type Place, rulesOf } from '../../schema/basics/index.ts';
import type { GeneratorSpec } from './generator-spec.ts';
import { fits, type Layout, NOVA_MARGIN } from './layout.ts';
import type { Way } from './tube.ts';

// px of a cell.
const CELL = 8;

// px from a way within which a nova touches whom flies there, at least.
const BESIDE = 20;

/**
 * At which places a nova of a radius, there or a little beside, leaves ways open, to the nearest cell of a grid: a forecast for many
 * places, at less cost than trying each.
 */
export function roomForNovae(
  layout: Layout,
  spec: GeneratorSpec,
  open: readonly Way[],
  radius: number,
): (place: Place) => boolean {
  const [columns, rows] = [Math.ceil(spec.width / CELL), Math.ceil(spec.height / CELL)];
  const isTaken = new Uint8Array(columns * rows);
  const cellOf = ({ x, y }: Place): number => Math.floor(y / CELL) * columns + Math.floor(x / CELL);
  const reach = radius + boxOf(rulesOf(layout)).halfDiagonal + spec.room - BESIDE;
  const steps = Math.ceil(reach / CELL);
  for (const cell of new Set(open.flat().map(cellOf))) {
    const [column, row] = [cell % columns, Math.floor(cell / columns)];
    for (let i = Math.max(0, row - steps); i <= Math.min(rows - 1, row + steps); i++) {
      for (let k = Math.max(0, column - steps); k <= Math.min(columns - 1, column + steps); k++) {
        const [down, right] = [(i - row) * CELL, (k - column) * CELL];
        if (down * down + right * right < reach * reach) isTaken[i * columns + k] = 1;
      }
    }
  }
  for (let cell = 0; cell < isTaken.length; cell++) {
    if (isTaken[cell] === 1) continue;
    const middle = { x: ((cell % columns) + 0.5) * CELL, y: (Math.floor(cell / columns) + 0.5) * CELL };
    if (!fits(layout, spec, { ...middle, radius }, undefined, NOVA_MARGIN)) isTaken[cell] = 1;
  }
  return ({ x, y }) => x >= 0 && y >= 0 && x < spec.width && y < spec.height && isTaken[cellOf({ x, y })] === 0;
}
