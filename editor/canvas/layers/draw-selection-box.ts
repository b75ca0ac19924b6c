import type { GameObjects } from 'phaser';
import { drawnBox, handlesOf, type SelectionBox } from '../selection-box/index.ts';
import type { View } from '../view.ts';

/** px of screen: half of the side of a handle, and the radius of the one that turns */
const HALF = 4;
const ROUND = 5;

/** Draws the box around the selection with its handles: squares scale it, the circle turns it. */
export function drawSelectionBox(
  graphics: GameObjects.Graphics,
  selection: SelectionBox | null,
  view: View,
  colour: number,
): void {
  if (selection === null) return;
  const { zoom } = view;
  const { left, top, right, bottom } = drawnBox(selection, zoom);
  graphics.lineStyle(1 / zoom, colour, 0.8).strokeRect(left, top, right - left, bottom - top);
  for (const { handle, at } of handlesOf(selection, view)) {
    graphics.lineStyle(1.5 / zoom, colour, 1);
    if (handle.does === 'turn') {
      graphics.lineBetween(at.x, at.y < top ? at.y + ROUND / zoom : at.y - ROUND / zoom, at.x, at.y < top ? top : bottom);
      graphics
        .fillStyle(0xffffff, 1)
        .fillCircle(at.x, at.y, ROUND / zoom)
        .strokeCircle(at.x, at.y, ROUND / zoom);
      continue;
    }
    const half = HALF / zoom;
    graphics.fillStyle(0xffffff, 1).fillRect(at.x - half, at.y - half, 2 * half, 2 * half);
    graphics.strokeRect(at.x - half, at.y - half, 2 * half, 2 * half);
  }
}
