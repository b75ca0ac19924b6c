import type { Ink } from '../ink.ts';
import { num, polyline } from '../xml.ts';

/** What a line of a diagram stands for. Each has a mark of its own shape. */
export type LineKind = Extract<Ink, 'arcade' | 'euler' | 'verlet' | 'rk4' | 'taylor' | 'peer'>;

function outline(kind: LineKind, x: number, y: number, r: number): string {
  const corners = (count: number, first: number, inner: number): string =>
    polyline(
      Array.from({ length: count }, (_, i) => {
        const angle = first + (2 * Math.PI * i) / count;
        const reach = i % 2 === 1 ? inner : r;
        return [x + reach * Math.cos(angle), y + reach * Math.sin(angle)] as const;
      }),
      true,
    );
  switch (kind) {
    case 'arcade':
      return corners(10, -Math.PI / 2, 0.45 * r);
    case 'euler':
      return corners(3, -Math.PI / 2, r);
    case 'verlet':
      return corners(4, Math.PI / 4, r);
    case 'rk4':
      return corners(4, 0, r);
    case 'taylor':
      return `M${num(x - 0.85 * r)} ${num(y)}a${num(0.85 * r)} ${num(0.85 * r)} 0 1 0 ${num(1.7 * r)} 0a${num(0.85 * r)} ${num(0.85 * r)} 0 1 0 ${num(-1.7 * r)} 0Z`;
    case 'peer':
      return corners(4, -Math.PI / 2, 0.5 * r);
  }
}

/**
 * Draws the mark of a line in `currentColor`.
 * @param r half its size
 * @param hollow whether it marks a failure
 */
export function drawMark(kind: LineKind, x: number, y: number, r: number, hollow: boolean): string {
  const fill = hollow ? 'fill="none" stroke="currentColor" stroke-width="1.3"' : 'fill="currentColor"';
  return `<path d="${outline(kind, x, y, r)}" ${fill} stroke-linejoin="round"/>`;
}
