import type { Circle } from '../../schema/index.ts';
import type { Theme } from '../theme.ts';
import { num } from '../xml.ts';
import type { KindInPicture } from './kind-in-picture.ts';

/** The lit side, the middle and the shade. */
const INK = {
  dark: ['#dff6ff', '#62c6ff', '#1f74c9'],
  light: ['#cfefff', '#3ba9ee', '#135ea8'],
} as const;

/** Draws a mineral around its centre: a cut gem that fills its circle. */
function drawMineral(radius: number, theme: Theme): string {
  const [lit, middle, shade] = INK[theme.name];
  return (
    `<g transform="scale(${num(radius / 7)})"><circle r="10" fill="${middle}" fill-opacity=".16"/>` +
    `<path d="M-4.4-5.2H4.4L7-1.4L0 7L-7-1.4Z" fill="${middle}"/><path d="M-4.4-5.2L-7-1.4L-2.7-1.4ZM0-5.2L-2.7-1.4H2.7Z" fill="${lit}"/>` +
    `<path d="M2.7-1.4L7-1.4L0 7Z" fill="${shade}"/>` +
    `<path d="M-4.4-5.2H4.4L7-1.4L0 7L-7-1.4ZM-7-1.4H7M-2.7-1.4L0 7L2.7-1.4L0-5.2Z" fill="none" stroke="${shade}" stroke-width=".5" stroke-linejoin="round"/></g>`
  );
}

export const mineral: KindInPicture<Circle> = {
  depth: 7,
  draw: ({ radius, theme }) => drawMineral(radius, theme),
  speck({ radius, theme }) {
    const r = num(radius);
    return `<path d="M0-${r}L${r} 0L0 ${r}L-${r} 0Z" fill="${INK[theme.name][1]}"/>`;
  },
  legend: { radius: 7 },
};
