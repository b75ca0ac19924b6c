import type { GameObjects, Scene } from 'phaser';
import { heatShades } from '../../../picture/index.ts';
import type { DeathMap } from '../../shelf/index.ts';
import { type Colours, colourNumber, deathOpacity } from '../colours.ts';

/** The heat map of deaths: squares above space, below the objects. */
export class DeathLayer {
  private readonly graphics: GameObjects.Graphics;

  constructor(
    scene: Scene,
    private readonly colours: Colours,
  ) {
    this.graphics = scene.add.graphics().setDepth(0.3);
  }

  /** @param deaths null: none are shown */
  show(deaths: DeathMap | null): void {
    this.graphics.clear();
    if (deaths === null) return;
    const { cellSize } = deaths;
    const colour = colourNumber(this.colours.death);
    for (const { opacity, cells } of heatShades(deaths)) {
      this.graphics.fillStyle(colour, deathOpacity(opacity));
      for (const { x, y } of cells) this.graphics.fillRect(x - cellSize / 2, y - cellSize / 2, cellSize, cellSize);
    }
  }

  destroy(): void {
    this.graphics.destroy();
  }
}
