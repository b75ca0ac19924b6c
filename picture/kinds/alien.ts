import type { Circle, Rules } from '../../schema/index.ts';
import type { Theme } from '../theme.ts';
import { num } from '../xml.ts';
import type { KindInPicture } from './kind-in-picture.ts';

/** The body, and the eyes. */
export const ALIEN_INK = { dark: '#7be06b', light: '#3fa433' } as const;
const EYES = { dark: '#0c1b0e', light: '#ffffff' } as const;

// Within a circle of radius 25: antennae, a dome, and a skirt of tentacles.
const BODY =
  'M-17 4C-18-13-9-19 0-19S18-13 17 4C17 9 19 14 15 18C12 20 11 15 9 15S7 21 4 21S2 16 0 16S-1 21-4 21S-7 15-9 15S-12 20-15 18C-19 14-17 9-17 4Z';
const ANTENNAE = 'M-6-18C-7-21-9-22-10.5-22M6-18C7-21 9-22 10.5-22';

/** Draws an alien around its centre: a small creature with two large eyes, inside the deadly circle. */
function drawAlien(radius: number, theme: Theme): string {
  return (
    `<g transform="scale(${num(radius / 25)})"><circle r="25" fill="${ALIEN_INK[theme.name]}" fill-opacity=".13" stroke="${ALIEN_INK[theme.name]}" stroke-opacity=".75" stroke-width="1.2" stroke-dasharray="4 3"/>` +
    `<path d="${ANTENNAE}" fill="none" stroke="${ALIEN_INK[theme.name]}" stroke-width="1.8" stroke-linecap="round"/>` +
    `<circle cx="-11" cy="-22" r="2" fill="${ALIEN_INK[theme.name]}"/><circle cx="11" cy="-22" r="2" fill="${ALIEN_INK[theme.name]}"/>` +
    `<path d="${BODY}" fill="${ALIEN_INK[theme.name]}"/>` +
    `<g fill="${EYES[theme.name]}"><ellipse cx="-7" cy="-3.5" rx="4.6" ry="6.4" transform="rotate(14 -7 -3.5)"/><ellipse cx="7" cy="-3.5" rx="4.6" ry="6.4" transform="rotate(-14 7 -3.5)"/></g>` +
    `<g fill="${ALIEN_INK[theme.name]}"><circle cx="-5.4" cy="-6" r="1.6"/><circle cx="8.4" cy="-6" r="1.6"/></g>` +
    `<path d="M-4 8.5Q0 11.5 4 8.5" fill="none" stroke="${EYES[theme.name]}" stroke-width="1.5" stroke-linecap="round"/></g>`
  );
}

/** Draws the circle of its sight, around its centre. */
const drawSight = (theme: Theme, { alienSight }: Rules): string =>
  `<circle r="${num(alienSight)}" fill="${ALIEN_INK[theme.name]}" fill-opacity=".035" stroke="${ALIEN_INK[theme.name]}" stroke-opacity=".55" stroke-width="1.1" stroke-dasharray="9 4 2 4"/>`;

export const alien: KindInPicture<Circle> = {
  depth: 6,
  draw: ({ radius, theme }) => drawAlien(radius, theme),
  speck({ radius, theme }) {
    const r = num(radius);
    return `<path d="M-${r} ${r}V0A${r} ${r} 0 0 1 ${r} 0V${r}Z" fill="${ALIEN_INK[theme.name]}"/>`;
  },
  around: { depth: 2, name: 'sight', draw: drawSight },
  legend: { radius: 25 },
};
