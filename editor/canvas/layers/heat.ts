import type { GameObjects } from 'phaser';
import { heatShades } from '../../../picture/index.ts';
import type { Explored } from '../../../solver/index.ts';

/**
 * Fills the squares of a heat map.
 * @param opacityOf the opacity of a shade on the canvas, 0 to 1, from that in pictures
 */
export function fillSquares(
  graphics: GameObjects.Graphics,
  explored: Explored,
  colour: number,
  opacityOf: (shade: number) => number,
): void {
  const { cellSize } = explored;
  for (const { opacity, cells } of heatShades(explored)) {
    graphics.fillStyle(colour, opacityOf(opacity));
    for (const { x, y } of cells) graphics.fillRect(x - cellSize / 2, y - cellSize / 2, cellSize, cellSize);
  }
}
