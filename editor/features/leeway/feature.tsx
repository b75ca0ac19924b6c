import type { Feature } from '../feature.ts';
import { LeewayLegend } from './LeewayLegend.tsx';
import { LeewayShade } from './LeewayShade.tsx';
import { LEEWAY_KEY } from './watch-leeway.ts';

/** Where the selection may stand without the run ending otherwise. */
export const leeway: Feature = {
  name: 'leeway',
  layers: [{ id: 'leeway', title: 'places where the selection may stand', keys: [LEEWAY_KEY], isShown: false }],
  canvas: { labels: LeewayShade, legend: LeewayLegend },
};
