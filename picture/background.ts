import { type Level, LISTED_KINDS, SINGLE_KINDS } from '../schema/index.ts';
import { IN_PICTURE } from './kinds/index.ts';
import { randomFrom, seedOf } from './random.ts';
import type { Theme } from './theme.ts';
import type { View } from './view.ts';
import { num, radial } from './xml.ts';

/** Draws space with specks of stars. They depend on the level only, so that all pictures of a level have the same ones. */
export function drawBackground(view: View, theme: Theme, level: Level): string {
  const random = randomFrom(seedOf(level.name));
  const count = Math.round((view.width * view.height) / 3000);
  // Three sizes, with one path for each.
  const specks = ['', '', ''];
  for (let i = 0; i < count; i++) {
    const size = random() ** 3 * 3;
    specks[Math.floor(size)] += `M${num(random() * view.width)} ${num(random() * view.height)}h.01`;
  }
  const stars = specks
    .map((d, i) => (d === '' ? '' : `<path d="${d}" stroke-width="${num(0.9 + 0.6 * i)}" opacity="${num(0.4 + 0.2 * i)}"/>`))
    .join('');
  return (
    `<rect width="${num(view.width)}" height="${num(view.height)}" fill="url(#gq-space)"/>` +
    `<g data-kind="stars" stroke="${theme.star}" stroke-linecap="round">${stars}</g>`
  );
}

/** The gradients that all pictures of a theme share. */
export function drawGradients(theme: Theme): string {
  const own = [...LISTED_KINDS, ...SINGLE_KINDS].flatMap((kind) => IN_PICTURE[kind].gradients?.(theme) ?? []);
  return `<defs>${[
    radial(
      'space',
      [
        [0, theme.space[0]],
        [1, theme.space[1]],
      ],
      ' cx=".5" cy=".42" r=".8"',
    ),
    ...own,
  ].join('')}</defs>`;
}

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
