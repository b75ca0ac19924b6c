import type { Run } from '../engine/index.ts';
import type { Theme } from './theme.ts';
import type { View } from './view.ts';
import { stretchesOf } from './way.ts';
import { num } from './xml.ts';

const CROSS = 'm-3-3l6 6m0-6l-6 6';

/** Draws her paths for shifted presses and releases: those that still reach the black hole, and those that fail. */
export function drawFan(view: View, theme: Theme, runs: readonly Run[]): string {
  const draw = (completes: boolean): string => {
    let d = '';
    let ends = '';
    for (const run of runs) {
      if ((run.outcome === 'completed') !== completes) continue;
      for (const { points } of stretchesOf(run)) {
        d += `M${points.map(([x, y]) => `${num(view.x(x))} ${num(view.y(y))}`).join('L')}`;
      }
      if (!completes) ends += `M${num(view.x(run.final.x))} ${num(view.y(run.final.y))}${CROSS}`;
    }
    if (d === '') return '';
    // Dashes distinguish them without colour.
    const dash = completes ? '' : ' stroke-dasharray="5 3"';
    const crosses = ends === '' ? '' : `<path d="${ends}" stroke-width="1.6" stroke-opacity=".9"/>`;
    return (
      `<g data-kind="fan-${completes ? 'completed' : 'failed'}" stroke="${completes ? theme.good : theme.bad}">` +
      `<path d="${d}" stroke-width="1" stroke-opacity="${completes ? 0.35 : 0.5}"${dash}/>${crosses}</g>`
    );
  };
  return `<g data-kind="fan" fill="none" stroke-linecap="round" stroke-linejoin="round">${draw(true)}${draw(false)}</g>`;
}

/** The icons of both kinds of paths, for the legend. */
export const drawFanSign = (theme: Theme, completes: boolean): string =>
  `<path d="M-10 4C-4-5 4-5 10 0" fill="none" stroke="${completes ? theme.good : theme.bad}" stroke-width="1.6" stroke-linecap="round"${completes ? '' : ' stroke-dasharray="5 3"'}/>`;
