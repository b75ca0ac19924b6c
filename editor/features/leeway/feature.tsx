import { laterOnce } from '../../core/panel/index.ts';
import type { Session } from '../../core/session/index.ts';
import type { Feature } from '../feature.ts';
import './leeway.css';

const isShown = ({ layers }: Session) => layers.leeway;

const LeewayShade = laterOnce(isShown, () => import('./LeewayShade.tsx').then((there) => there.LeewayShade));
const LeewayLegend = laterOnce(isShown, () => import('./LeewayShade.tsx').then((there) => there.LeewayLegend));

/** Shows or hides where the selection may stand. */
const LEEWAY_KEY = 'Shift+l';

/** Where the selection may stand without the run ending otherwise. */
export const leeway: Feature = {
  name: 'leeway',
  layers: [{ id: 'leeway', title: 'places where the selection may stand', keys: [LEEWAY_KEY], isShown: false }],
  canvas: { labels: LeewayShade, legend: () => <LeewayLegend shortcut={LEEWAY_KEY} /> },
};
