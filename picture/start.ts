import { boxOf, type Run } from '../engine/index.ts';
import { type Level, rulesOf } from '../schema/index.ts';
import { drawAstronaut } from './kinds/index.ts';
import { place } from './place.ts';
import type { Point } from './simplify.ts';
import { drawText } from './text.ts';
import type { Theme } from './theme.ts';
import type { View } from './view.ts';
import { positionAt } from './way.ts';

// She has left the place of her box after this time, s.
const SOON = 3;

/** The centre of the label beside the start, on the side towards which she does not move. */
export function startLabelAt(view: View, level: Level, run: Run | undefined): Point {
  const { x, y } = level.astronaut;
  const leavesDown = run !== undefined && positionAt(run, SOON)[1] > y;
  const off = boxOf(rulesOf(level)).halfHeight * view.scale + 9;
  return [view.x(x), view.y(y) + (leavesDown ? -off : off)];
}

/** Draws the astronaut at the start, upright in her box. */
export const drawStartFigure = (view: View, theme: Theme, level: Level): string =>
  place(view, 'astronaut', 0, level.astronaut, drawAstronaut(theme, theme.muted, boxOf(rulesOf(level))));

/** Draws the astronaut at the start, with a label. */
export function drawStart(view: View, theme: Theme, level: Level, run: Run | undefined): string {
  const [x, y] = startLabelAt(view, level, run);
  const label = drawText('start', x, y + 3.3, { size: 6.5, color: theme.muted, anchor: 'middle' });
  return drawStartFigure(view, theme, level) + label;
}
