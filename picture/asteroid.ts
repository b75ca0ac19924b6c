import { randomFrom } from './random.ts';
import type { Theme } from './theme.ts';
import { num } from './xml.ts';

/** A cold asteroid around its centre: lit from the upper left, with craters. */
export function drawAsteroid(radius: number, index: number, theme: Theme): string {
  const random = randomFrom(7919 * (index + 1));
  const turn = random() * 2 * Math.PI;
  let craters = '';
  let edges = '';
  const count = radius < 10 ? 3 : 5;
  for (let i = 0; i < count; i++) {
    // evenly around, at alternating distances, so that craters neither overlap nor leave the disc
    const angle = turn + (i * 2 * Math.PI) / count + (random() - 0.5) * 0.5;
    const out = radius * (i % 2 === 0 ? 0.6 : 0.36) * (0.92 + 0.16 * random());
    const r = radius * (i % 2 === 0 ? 0.15 : 0.19) * (0.75 + 0.5 * random());
    const x = out * Math.cos(angle);
    const y = out * Math.sin(angle);
    craters += `<circle cx="${num(x)}" cy="${num(y)}" r="${num(r)}"/>`;
    edges += `M${num(x + r)} ${num(y)}A${num(r)} ${num(r)} 0 0 1 ${num(x)} ${num(y + r)}`;
  }
  return (
    `<circle r="${num(radius)}" fill="url(#gq-rock)"/><g fill="${theme.crater}" fill-opacity=".75">${craters}</g>` +
    `<path d="${edges}" fill="none" stroke="${theme.craterEdge}" stroke-width="${num(radius * 0.045)}" stroke-linecap="round" opacity=".8"/>`
  );
}
