import type { Run } from '../engine/index.ts';
import type { Level } from '../schema/index.ts';
import { place } from './place.ts';
import type { Theme } from './theme.ts';
import type { View } from './view.ts';

/** The mark of a collected mineral, around its centre. */
const drawTick = (theme: Theme): string =>
  `<g fill="none" stroke-linecap="round" stroke-linejoin="round"><circle r="11.5" stroke="${theme.good}" stroke-width="1.3"/>` +
  `<path d="M6.5-9.5L9.8-6L16-13.5" stroke="${theme.halo}" stroke-width="5.5"/><path d="M6.5-9.5L9.8-6L16-13.5" stroke="${theme.good}" stroke-width="2.6"/></g>`;

/** Marks each mineral that the run collects. */
export function drawCollected(view: View, theme: Theme, level: Level, run: Run): string {
  const indices = [...new Set(run.minerals.map(({ index }) => index))];
  return indices.map((i) => place(view, 'collected', i, level.minerals[i], drawTick(theme))).join('');
}
