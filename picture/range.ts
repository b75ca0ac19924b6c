import type { Level } from '../schema/index.ts';
import type { Theme } from './theme.ts';
import type { View } from './view.ts';
import { num } from './xml.ts';

// More discs than this say nothing and hide everything else.
const MOST = 200;

/** Draws the ranges of the asteroids as faint discs, brighter where they overlap. */
export function drawRanges(view: View, theme: Theme, level: Level): string {
  if (level.asteroids.length > MOST) return '';
  const discs = level.asteroids
    .map(
      ({ x, y }, i) =>
        `<circle data-kind="range" data-index="${i}" cx="${num(view.x(x))}" cy="${num(view.y(y))}" r="${num(level.range * view.scale)}"/>`,
    )
    .join('');
  return `<g fill="${theme.range}" fill-opacity=".035" stroke="${theme.range}" stroke-opacity=".22" stroke-dasharray="1.5 7" stroke-linecap="round">${discs}</g>`;
}
