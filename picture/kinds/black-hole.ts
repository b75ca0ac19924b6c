import type { Theme } from '../theme.ts';
import { num, polyline, radial } from '../xml.ts';
import type { KindInPicture } from './kind-in-picture.ts';

const ARMS = 3;
const STEPS = 22;

/** One arm of the spiral, from the rim outwards: a logarithmic spiral r = r0 e^(k angle). */
function arm(radius: number, turn: number): string {
  const points: [number, number][] = [];
  for (let i = 0; i <= STEPS; i++) {
    const t = i / STEPS;
    const r = radius * 1.06 * Math.exp(0.6 * t);
    const angle = turn + 2.5 * t;
    points.push([r * Math.cos(angle), r * Math.sin(angle)]);
  }
  return polyline(points);
}

/** Draws the black hole around its centre: a dark disc with a bright rim, in a spiral of matter. */
function drawBlackHole(radius: number, theme: Theme): string {
  let arms = '';
  let wisps = '';
  for (let i = 0; i < ARMS; i++) {
    arms += arm(radius, (i * 2 * Math.PI) / ARMS);
    wisps += arm(1.12 * radius, (i * 2 * Math.PI) / ARMS + 0.6);
  }
  return (
    `<circle r="${num(2.3 * radius)}" fill="url(#gq-disc)"/><g fill="none" stroke="${theme.disc}" stroke-linecap="round">` +
    `<path d="${wisps}" stroke-width="${num(0.05 * radius)}" opacity=".6"/><path d="${arms}" stroke-width="${num(0.11 * radius)}"/></g>` +
    `<circle r="${num(radius)}" fill="${theme.hole}" stroke="${theme.disc}" stroke-width="${num(0.09 * radius)}"/>` +
    `<circle r="${num(0.88 * radius)}" fill="none" stroke="#fff" stroke-opacity=".35" stroke-width="${num(0.03 * radius)}"/>`
  );
}

export const blackHole: KindInPicture = {
  depth: 3,
  draw: ({ radius, theme }) => drawBlackHole(radius, theme),
  speck: ({ radius, theme }) => `<circle r="${num(radius)}" fill="${theme.hole}" stroke="${theme.disc}"/>`,
  reach: 1.9,
  gradients: ({ disc, hole }) => [
    radial('hole', [
      [0.7, hole],
      [0.93, hole],
      [1, disc],
    ]),
    radial('disc', [
      [0.42, disc, 0.75],
      [0.65, disc, 0.25],
      [1, disc, 0],
    ]),
  ],
  legend: { radius: 16, factor: 0.72 },
};
