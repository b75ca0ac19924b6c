import type { Circle } from '../../schema/index.ts';
import type { Theme } from '../theme.ts';
import { num, radial } from '../xml.ts';
import type { KindInPicture } from './kind-in-picture.ts';

const INK = { dark: '#4fd8d0', light: '#0f8f89' } as const;

/** Draws a repulsor around its centre: a dashed disc with arrows that point outwards. */
function drawRepulsor(radius: number, theme: Theme): string {
  const from = 0.34 * radius;
  const to = 0.8 * radius;
  const head = Math.min(0.15 * radius, 7);
  const arrow = `M${num(from)} 0H${num(to)}M${num(to - head)} ${num(-head)}L${num(to)} 0L${num(to - head)} ${num(head)}`;
  let arrows = '';
  for (let turn = 0; turn < 360; turn += 45) arrows += `<path d="${arrow}" transform="rotate(${turn})"/>`;
  const width = num(Math.min(2.2, 0.05 * radius));
  return (
    `<circle r="${num(radius)}" fill="url(#gq-field)" stroke="${INK[theme.name]}" stroke-width="${width}" stroke-dasharray="${num(radius * 0.13)} ${num(radius * 0.0795)}"/>` +
    `<g fill="none" stroke="${INK[theme.name]}" stroke-width="${width}" stroke-linecap="round" stroke-linejoin="round" opacity=".9">${arrows}</g>` +
    `<circle r="${num(0.11 * radius)}" fill="${INK[theme.name]}"/>`
  );
}

export const repulsor: KindInPicture<Circle> = {
  depth: 1,
  draw: ({ radius, theme }) => drawRepulsor(radius, theme),
  speck: ({ radius, theme }) =>
    `<circle r="${num(radius)}" fill="${INK[theme.name]}" fill-opacity=".2" stroke="${INK[theme.name]}" stroke-dasharray="4 3"/>`,
  gradients: (theme) => [
    radial('field', [
      [0, INK[theme.name], 0.3],
      [1, INK[theme.name], 0.1],
    ]),
  ],
  legend: { radius: 16 },
};
