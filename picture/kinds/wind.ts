import type { ObjectOf } from '../../schema/index.ts';
import { num } from '../xml.ts';
import type { KindInPicture } from './kind-in-picture.ts';

const INK = { dark: '#8fd3ff', light: '#1c74b8' } as const;

/** A streak with an arrowhead, along x, around the origin. */
const streak = (y: number, from: number, to: number, head: number): string =>
  `M${num(from)} ${num(y)}H${num(to)}M${num(to - head)} ${num(y - head)}L${num(to)} ${num(y)}L${num(to - head)} ${num(y + head)}`;

/** Draws a wind as a disc with streaks in its direction; the stronger it is, the longer they are. */
export const wind: KindInPicture<ObjectOf<'wind'>> = {
  depth: 1.5,
  draw({ object: { ax, ay }, radius, theme }) {
    const ink = INK[theme.name];
    const strength = Math.hypot(ax, ay);
    const turn = num((Math.atan2(ay, ax) * 180) / Math.PI);
    const length = radius * (0.25 + 0.5 * Math.min(1, strength / 100));
    const head = Math.min(0.12 * radius, 8);
    const d = [-0.45, 0, 0.45].map((row) => streak(row * radius, -length, length * (row === 0 ? 1 : 0.75), head)).join('');
    const arrows = `<path d="${d}" transform="rotate(${turn})" fill="none" stroke="${ink}" stroke-width="${num(Math.min(2.4, 0.06 * radius))}" stroke-linecap="round" stroke-linejoin="round"/>`;
    return (
      `<circle r="${num(radius)}" fill="${ink}" fill-opacity=".1" stroke="${ink}" stroke-opacity=".7" stroke-width="1.2" stroke-dasharray="1 5" stroke-linecap="round"/>` +
      (strength === 0 ? '' : arrows)
    );
  },
  speck: ({ radius, theme }) =>
    `<circle r="${num(radius)}" fill="${INK[theme.name]}" fill-opacity=".15" stroke="${INK[theme.name]}" stroke-dasharray="1 3"/>`,
  legend: { radius: 24 },
};
