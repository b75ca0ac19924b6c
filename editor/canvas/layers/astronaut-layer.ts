import type { GameObjects, Scene } from 'phaser';
import type { Box } from '../../../engine/index.ts';
import { TEXTURE_UNIT } from '../../../phaser/index.ts';
import type { Place } from '../../../schema/index.ts';
import type { Pose } from '../../core/context/index.ts';
import { type Colours, colourNumber } from '../colours.ts';

/** px of half the box that her texture is drawn for */
const DRAWN_WIDTH = 10;
const DRAWN_HEIGHT = 16;

/** The scale at which she fits into her box. */
export const scaleIn = ({ halfWidth, halfHeight }: Box): number =>
  (Math.min(halfWidth / DRAWN_WIDTH, halfHeight / DRAWN_HEIGHT) * DRAWN_HEIGHT) / TEXTURE_UNIT;
const SPARKS = 14;

/** The astronaut and the beam of her gun. */
export class AstronautLayer {
  private readonly beam: GameObjects.Graphics;
  private readonly body: GameObjects.Image;
  /** Her start, drawn faintly while she is shown elsewhere. */
  private readonly start: GameObjects.Image;
  private readonly sparks: readonly GameObjects.Image[];

  constructor(
    scene: Scene,
    private readonly colours: Colours,
  ) {
    this.beam = scene.add.graphics().setDepth(8);
    this.sparks = Array.from({ length: SPARKS }, () => scene.add.image(0, 0, 'spark').setDepth(8).setVisible(false));
    this.start = scene.add.image(0, 0, 'astronaut').setDepth(6.5).setAlpha(0.35);
    this.body = scene.add.image(0, 0, 'astronaut').setDepth(9);
  }

  /**
   * @param from where she starts, px
   * @param box her collision box
   * @param time s, for the sparks along the beam
   * @param calm whether the user wants reduced motion
   */
  show({ x, y, cos, sin, beamTo }: Pose, from: Place, box: Box, time: number, calm: boolean): void {
    const scale = scaleIn(box);
    this.body.setScale(scale).setPosition(x, y).setRotation(Math.atan2(sin, cos));
    this.start
      .setScale(scale)
      .setPosition(from.x, from.y)
      .setVisible(from.x !== x || from.y !== y);
    this.beam.clear();
    for (const spark of this.sparks) spark.setVisible(beamTo !== null && !calm);
    if (beamTo === null) return;
    const colour = colourNumber(this.colours.beam);
    for (const [width, alpha] of [
      [7, 0.12],
      [3.5, 0.25],
      [1.4, 0.9],
    ] as const) {
      this.beam.lineStyle(width, colour, alpha).lineBetween(x, y, beamTo.x, beamTo.y);
    }
    if (calm) return;
    const dx = beamTo.x - x;
    const dy = beamTo.y - y;
    const length = Math.max(1, Math.hypot(dx, dy));
    for (const [i, spark] of this.sparks.entries()) {
      // sparks run from the asteroid to her and sway around the beam
      const share = 1 - ((time * 0.9 + i / SPARKS) % 1);
      const sway = 4 * Math.sin(17 * share + 2.4 * i + 6 * time) * (1 - share);
      spark.setPosition(x + dx * share - (dy / length) * sway, y + dy * share + (dx / length) * sway);
      spark
        .setScale(0.035 + 0.03 * ((i % 3) / 3))
        .setTint(colour)
        .setAlpha(0.35 + 0.65 * share);
    }
  }

  destroy(): void {
    this.beam.destroy();
    this.body.destroy();
    this.start.destroy();
    for (const spark of this.sparks) spark.destroy();
  }
}
