import type { ObjectOf } from '../../schema/index.ts';
import { num, polyline } from '../xml.ts';
import type { KindInPicture } from './kind-in-picture.ts';

const INK = { dark: '#ff9de2', light: '#b0128a' } as const;

/** Draws the mouths as rings that turn inwards, with opposite senses at the two mouths, and a line between them. */
export const wormhole: KindInPicture<ObjectOf<'wormhole'>> = {
  depth: 3.5,
  draw({ place, radius, theme }) {
    const ink = INK[theme.name];
    const points = Array.from({ length: 90 }, (_, i): [number, number] => {
      const angle = (place === 0 ? 1 : -1) * 0.2 * i;
      const out = radius * (1 - i / 98);
      return [out * Math.cos(angle), out * Math.sin(angle)];
    });
    return (
      `<circle r="${num(radius)}" fill="${theme.hole}" fill-opacity=".55" stroke="${ink}" stroke-width="${num(0.08 * radius)}"/>` +
      `<path d="${polyline(points)}" fill="none" stroke="${ink}" stroke-opacity=".75" stroke-width="${num(0.06 * radius)}" stroke-linecap="round"/>`
    );
  },
  between({ object: { x, y, toX, toY }, radius, theme }) {
    const [dx, dy] = [toX - x, toY - y];
    const length = Math.hypot(dx, dy);
    if (length <= 2 * radius) return '';
    const at = (out: number): string => `${num((dx * out) / length)} ${num((dy * out) / length)}`;
    return `<path d="M${at(radius)}L${at(length - radius)}" stroke="${INK[theme.name]}" stroke-opacity=".6" stroke-width="1.2" stroke-dasharray="5 6"/>`;
  },
  speck: ({ radius, theme }) =>
    `<circle r="${num(0.8 * radius)}" fill="none" stroke="${INK[theme.name]}" stroke-width="${num(0.4 * radius)}"/>`,
  legend: { radius: 16 },
};
