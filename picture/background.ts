import type { Level } from '../schema/index.ts';
import { randomFrom, seedOf } from './random.ts';
import type { Theme } from './theme.ts';
import type { View } from './view.ts';
import { num } from './xml.ts';

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
