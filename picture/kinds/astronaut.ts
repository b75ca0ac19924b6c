import { type Box, boxOf } from '../../engine/index.ts';
import type { Theme } from '../theme.ts';
import { num } from '../xml.ts';
import type { KindInPicture } from './kind-in-picture.ts';

/**
 * Draws the astronaut around her centre, upright in her box; rotate the group for another angle. Her figure is drawn for 20 x
 * 32 px and scaled to the box.
 */
export function drawAstronaut(theme: Theme, boxColor: string, { halfWidth, halfHeight }: Box): string {
  const { suit, suitEdge, visor } = theme;
  const fit = Math.min(halfWidth / 10, halfHeight / 16);
  const figure =
    `<g stroke="${suitEdge}" stroke-width=".9" stroke-linejoin="round"><rect x="-7.6" y="-5" width="15.2" height="10.5" rx="2.5" fill="${suitEdge}"/>` +
    `<path d="M-4.8-3.5C-8-2.5-8.8 1-8.4 4.6C-8.2 6.2-5.8 6-5.6 4.5L-5 7.5L-5.4 13.8C-5.4 15.4-1 15.4-.9 13.8L0 9.5L.9 13.8C1 15.4 5.4 15.4 5.4 13.8L5 7.5L5.6 4.5C5.8 6 8.2 6.2 8.4 4.6C8.8 1 8-2.5 4.8-3.5Z" fill="${suit}"/>` +
    `<circle cy="-8.6" r="6.6" fill="${suit}"/><rect x="-4.5" y="-11.8" width="9" height="6.6" rx="3.1" fill="${visor}"/></g>` +
    `<path d="M-2.6-10.2C-1.8-11-.6-11.1.4-11" fill="none" stroke="#fff" stroke-width="1" stroke-linecap="round"/>` +
    `<path d="M-2.4.6H2.4M-2.4 2.8H1" stroke="${theme.bad}" stroke-width="1.1" stroke-linecap="round"/>`;
  return (
    `<rect x="${num(-halfWidth)}" y="${num(-halfHeight)}" width="${num(2 * halfWidth)}" height="${num(2 * halfHeight)}" rx="1" fill="${theme.halo}" fill-opacity=".55" stroke="${boxColor}" stroke-width="1.1"/>` +
    (fit === 1 ? figure : `<g transform="scale(${num(fit)})">${figure}</g>`)
  );
}

/** The astronaut at the start; the run also draws her at its end. */
export const astronaut: KindInPicture = {
  depth: null,
  draw: ({ theme, rules }) => drawAstronaut(theme, theme.muted, boxOf(rules)),
  speck: ({ theme, rules }) => drawAstronaut(theme, theme.muted, boxOf(rules)),
  legend: null,
};
