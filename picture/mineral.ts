import type { Theme } from './theme.ts';
import { num } from './xml.ts';

/** A mineral around its centre: a cut gem that fills its circle. */
export function drawMineral(radius: number, theme: Theme): string {
  const [lit, middle, shade] = theme.mineral;
  return (
    `<g transform="scale(${num(radius / 7)})"><circle r="10" fill="${middle}" fill-opacity=".16"/>` +
    `<path d="M-4.4-5.2H4.4L7-1.4L0 7L-7-1.4Z" fill="${middle}"/><path d="M-4.4-5.2L-7-1.4L-2.7-1.4ZM0-5.2L-2.7-1.4H2.7Z" fill="${lit}"/>` +
    `<path d="M2.7-1.4L7-1.4L0 7Z" fill="${shade}"/>` +
    `<path d="M-4.4-5.2H4.4L7-1.4L0 7L-7-1.4ZM-7-1.4H7M-2.7-1.4L0 7L2.7-1.4L0-5.2Z" fill="none" stroke="${shade}" stroke-width=".5" stroke-linejoin="round"/></g>`
  );
}

/** The sign that a mineral was collected, around its centre. */
export const drawTick = (theme: Theme): string =>
  `<g fill="none" stroke-linecap="round" stroke-linejoin="round"><circle r="11.5" stroke="${theme.good}" stroke-width="1.3"/>` +
  `<path d="M6.5-9.5L9.8-6L16-13.5" stroke="${theme.halo}" stroke-width="5.5"/><path d="M6.5-9.5L9.8-6L16-13.5" stroke="${theme.good}" stroke-width="2.6"/></g>`;
