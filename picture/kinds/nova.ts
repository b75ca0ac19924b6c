import type { Circle } from '../../schema/index.ts';
import type { Theme } from '../theme.ts';
import { num, polyline, radial } from '../xml.ts';
import type { KindInPicture } from './kind-in-picture.ts';

/** Core, middle and edge. */
const INK = {
  dark: ['#ffffff', '#ffc6ee', '#e0489f'],
  light: ['#ffffff', '#ff9fda', '#c2227d'],
} as const;

/** The outline of a star around the origin with spikes of length `outer`. */
function star(spikes: number, outer: number, inner: number, turn: number): string {
  const points: [number, number][] = [];
  for (let i = 0; i < 2 * spikes; i++) {
    const r = i % 2 === 0 ? outer : inner;
    const angle = turn + (i * Math.PI) / spikes;
    points.push([r * Math.cos(angle), r * Math.sin(angle)]);
  }
  return polyline(points, true);
}

/** Draws a nova around its centre: a spiky star that fills its circle, in a glow. */
function drawNova(radius: number, index: number, theme: Theme): string {
  const turn = index * 0.7;
  return (
    `<circle r="${num(1.6 * radius)}" fill="url(#gq-glare)"/>` +
    `<circle r="${num(radius)}" fill="${INK[theme.name][2]}" fill-opacity=".25" stroke="${INK[theme.name][2]}" stroke-opacity=".8" stroke-width="${num(0.04 * radius)}"/>` +
    `<path d="${star(12, radius, 0.62 * radius, turn)}" fill="url(#gq-nova)"/>` +
    `<path d="${star(12, 0.62 * radius, 0.36 * radius, turn + Math.PI / 12)}" fill="${INK[theme.name][0]}" fill-opacity=".9"/>`
  );
}

export const nova: KindInPicture<Circle> = {
  depth: 5,
  draw: ({ radius, index, theme }) => drawNova(radius, index, theme),
  speck({ radius, theme }) {
    const r = num(radius);
    const h = num(0.35 * radius);
    return `<path d="M0-${r}L${h}-${h}L${r} 0L${h} ${h}L0 ${r}L-${h} ${h}L-${r} 0L-${h}-${h}Z" fill="${INK[theme.name][2]}"/>`;
  },
  gradients: ({ name }) => [
    radial('nova', [
      [0, INK[name][0]],
      [0.4, INK[name][1]],
      [1, INK[name][2]],
    ]),
    radial('glare', [
      [0.2, INK[name][2], 0.6],
      [0.55, INK[name][2], 0.2],
      [1, INK[name][2], 0],
    ]),
  ],
  legend: { radius: 16 },
};
