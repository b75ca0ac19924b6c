import { randomFrom } from '../random.ts';
import type { Theme } from '../theme.ts';
import { num, polyline } from '../xml.ts';

/** The lit side, the middle and the shade. */
export const EMBER = {
  dark: ['#ffb35c', '#d9481c', '#5c1408'],
  light: ['#ffa64d', '#d9481c', '#7a1c0c'],
} as const;
export const FLAMES = { dark: '#fff0b8', light: '#fff3c9' } as const;

// A flame around the origin, about 2 units high.
const FLAME = 'M0 1C-.75 1-.95.35-.7-.1C-.55-.4-.35-.5-.3-.95C.15-.75.3-.4.3-.1C.42-.2.5-.35.5-.5C.8-.1.95 1 0 1Z';

/** Draws a hot asteroid around its centre: glowing and cracked, with a flame on it. */
export function drawHotAsteroid(radius: number, index: number, theme: Theme): string {
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
