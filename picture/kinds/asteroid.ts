import type { Asteroid } from '../../schema/index.ts';
import { radial } from '../radial-gradient.ts';
import { randomFrom } from '../random.ts';
import type { Theme } from '../theme.ts';
import { num } from '../xml.ts';
import { drawHotAsteroid, EMBER, FLAMES } from './hot-asteroid.ts';
import type { KindInPicture } from './kind-in-picture.ts';

/** Draws a cold asteroid around its centre: lit from the upper left, with craters. */
function drawAsteroid(radius: number, index: number, theme: Theme): string {
  const random = randomFrom(7919 * (index + 1));
  const turn = random() * 2 * Math.PI;
  let craters = '';
  let edges = '';
  const count = radius < 10 ? 3 : 5;
  for (let i = 0; i < count; i++) {
    // Even angles and alternating distances keep craters from overlapping and from leaving the disc.
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

export const asteroid: KindInPicture<Asteroid> = {
  depth: 4,
  draw: ({ object, radius, index, theme }) => (object.hot ? drawHotAsteroid : drawAsteroid)(radius, index, theme),
  speck({ object, radius, theme }) {
    const r = num(radius);
    if (!object.hot) return `<circle r="${r}" fill="${theme.rock[1]}"/>`;
    const h = num(0.35 * radius);
    return `<circle r="${r}" fill="${EMBER[theme.name][1]}"/><path d="M0-${h}L${h} ${h}H-${h}Z" fill="${FLAMES[theme.name]}"/>`;
  },
  gradients: ({ rock, name }) => [
    radial(
      'rock',
      [
        [0, rock[0]],
        [0.55, rock[1]],
        [1, rock[2]],
      ],
      ' cx=".36" cy=".32" r=".78"',
    ),
    radial(
      'hot',
      [
        [0, EMBER[name][0]],
        [0.5, EMBER[name][1]],
        [1, EMBER[name][2]],
      ],
      ' cx=".5" cy=".5" r=".55"',
    ),
    radial('heat', [
      [0.45, EMBER[name][0], 0.55],
      [0.7, EMBER[name][1], 0.22],
      [1, EMBER[name][1], 0],
    ]),
  ],
  legend: { radius: 16 },
};
