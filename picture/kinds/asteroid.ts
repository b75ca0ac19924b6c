import type { Asteroid } from '../../schema/index.ts';
import { randomFrom } from '../random.ts';
import type { Theme } from '../theme.ts';
import { num, polyline, radial } from '../xml.ts';
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

/** The lit side, the middle and the shade. */
const EMBER = {
  dark: ['#ffb35c', '#d9481c', '#5c1408'],
  light: ['#ffa64d', '#d9481c', '#7a1c0c'],
} as const;
const FLAMES = { dark: '#fff0b8', light: '#fff3c9' } as const;

// A flame around the origin, about 2 units high.
const FLAME = 'M0 1C-.75 1-.95.35-.7-.1C-.55-.4-.35-.5-.3-.95C.15-.75.3-.4.3-.1C.42-.2.5-.35.5-.5C.8-.1.95 1 0 1Z';

/** Draws a hot asteroid around its centre: glowing and cracked, with a flame on it. */
function drawHotAsteroid(radius: number, index: number, theme: Theme): string {
  const random = randomFrom(104729 * (index + 1));
  const turn = random() * 2 * Math.PI;
  let cracks = '';
  for (let i = 0; i < 6; i++) {
    const angle = turn + (i * Math.PI) / 3 + (random() - 0.5) * 0.4;
    const at = (out: number, bend: number): [number, number] => [
      radius * out * Math.cos(angle + bend),
      radius * out * Math.sin(angle + bend),
    ];
    cracks += polyline([at(0.96, 0), at(0.8, 0.14), at(0.68, -0.1), at(0.54, 0.06)]);
  }
  return (
    `<circle r="${num(1.55 * radius)}" fill="url(#gq-heat)"/><circle r="${num(radius)}" fill="url(#gq-hot)"/>` +
    `<path d="${cracks}" fill="none" stroke="${EMBER[theme.name][0]}" stroke-width="${num(radius * 0.07)}" stroke-linejoin="round" stroke-linecap="round"/>` +
    `<path d="${FLAME}" transform="scale(${num(radius * 0.44)})" fill="${FLAMES[theme.name]}" stroke="${EMBER[theme.name][2]}" stroke-width=".14"/>`
  );
}
