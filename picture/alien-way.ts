import { ALIEN_INK } from './kinds/index.ts';
import type { Theme } from './theme.ts';
import type { View } from './view.ts';
import { num } from './xml.ts';

/** Draws the path of an alien that moved, and its last place: a ghost, or a burst if it had exploded. */
export function drawAlienWay(
  view: View,
  theme: Theme,
  way: readonly (readonly [number, number])[],
  radius: number,
  exploded: boolean,
): string {
  const points = way.map(([x, y]) => `${num(view.x(x))} ${num(view.y(y))}`).join('L');
  const [x, y] = way[way.length - 1];
  const r = radius * view.scale;
  let burst = '';
  for (let i = 0; i < 12; i++) {
    const [cos, sin] = [Math.cos((i * Math.PI) / 6), Math.sin((i * Math.PI) / 6)];
    const from = i % 2 === 0 ? 0.35 : 0.5;
    burst += `M${num(from * r * cos)} ${num(from * r * sin)}L${num(r * cos)} ${num(r * sin)}`;
  }
  const end = exploded
    ? `<path d="${burst}" stroke-width="2" stroke-linecap="round"/>`
    : `<circle r="${num(r)}" stroke-width="1.2" stroke-dasharray="4 3"/><circle cx="${num(-0.28 * r)}" cy="${num(-0.14 * r)}" r="${num(0.16 * r)}" stroke-width="1.2"/><circle cx="${num(0.28 * r)}" cy="${num(-0.14 * r)}" r="${num(0.16 * r)}" stroke-width="1.2"/>`;
  return (
    `<g data-kind="alien-way" fill="none" stroke="${ALIEN_INK[theme.name]}"><path d="M${points}" stroke-width="1.6" stroke-dasharray=".1 5" stroke-linecap="round"/>` +
    `<g transform="translate(${num(view.x(x))} ${num(view.y(y))})">${end}</g></g>`
  );
}
