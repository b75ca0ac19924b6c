import type { GameObjects, Scene } from 'phaser';
import { type Colours, colourNumber, type Drawing, deathOpacity, fillSquares } from '../../canvas/index.ts';
import type { DeathMap } from '../../core/shelf/index.ts';

/** The heat map of deaths: squares above space, below the objects. */
export class DeathLayer implements Drawing<DeathMap | null> {
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
    if (deaths !== null) fillSquares(this.graphics, deaths, colourNumber(this.colours.death), deathOpacity);
  }

  destroy(): void {
    this.graphics.destroy();
  }
}
