import type { GameObjects, Scene } from 'phaser';
import { type Colours, colourNumber, type Drawing, type Frame } from '../../canvas/index.ts';
import { LOST_SQUARE, type LostPicture, type LostSquare, type LostStretch } from './lost-picture.ts';

/** px of screen between the strokes of a proved square, and between the dots of another */
const HATCH = 7;
const DOTS = 8;
/** At most so many strokes or dots across a square, however large it is on the screen. */
const MOST_ACROSS = 8;

/** Squares in which it is already lost, and the parts of paths on which she is: strokes if it is proved, dots if not. */
export class LostLayer implements Drawing<LostPicture | null> {
  private readonly shade: GameObjects.Graphics;
  private readonly stretches: GameObjects.Graphics;
  private readonly colour: number;

  constructor(scene: Scene, colours: Colours) {
    this.shade = scene.add.graphics().setDepth(0.35);
    this.stretches = scene.add.graphics().setDepth(7.6);
    this.colour = colourNumber(colours.lost);
  }

  /** @param picture null: nothing is shown */
  show(picture: LostPicture | null, { zoom }: Frame): void {
    this.shade.clear();
    this.stretches.clear();
    if (picture === null) return;
    for (const square of picture.squares) {
      if (square.known === 'proved') this.hatch(square, zoom);
      else this.dots(square, zoom);
    }
    for (const stretch of picture.stretches) this.stretch(stretch, zoom);
  }

  destroy(): void {
    this.shade.destroy();
    this.stretches.destroy();
  }

  /** Strokes that go on from square to square. */
  private hatch({ x, y }: LostSquare, zoom: number): void {
    this.shade.fillStyle(this.colour, 0.14).fillRect(x, y, LOST_SQUARE, LOST_SQUARE);
    // whole numbers of strokes fit into a square
    const step = LOST_SQUARE / Math.max(1, Math.min(MOST_ACROSS, Math.round((LOST_SQUARE * zoom) / HATCH)));
    this.shade.lineStyle(1.6 / zoom, this.colour, 0.75).beginPath();
    for (let c = step / 2; c < 2 * LOST_SQUARE; c += step) {
      const from = Math.min(c, LOST_SQUARE);
      this.shade.moveTo(x + from, y + c - from).lineTo(x + c - from, y + from);
    }
    this.shade.strokePath();
  }

  private dots({ x, y }: LostSquare, zoom: number): void {
    const count = Math.max(1, Math.min(MOST_ACROSS, Math.round((LOST_SQUARE * zoom) / DOTS)));
    const step = LOST_SQUARE / count;
    this.shade.fillStyle(this.colour, 0.5);
    for (let i = 0; i < count; i++) {
      for (let k = 0; k < count; k++) {
        const radius = 1 / zoom;
        this.shade.fillRect(x + (i + 0.5) * step - radius, y + (k + 0.5) * step - radius, 2 * radius, 2 * radius);
      }
    }
  }

  private stretch({ at, known, points, isShownRun }: LostStretch, zoom: number): void {
    const isProved = known === 'proved';
    const width = (isShownRun ? 7 : 4) / zoom;
    if (isProved) {
      this.stretches.lineStyle(width, this.colour, 0.4).beginPath().moveTo(points[0], points[1]);
      for (let i = 2; i < points.length; i += 2) this.stretches.lineTo(points[i], points[i + 1]);
      this.stretches.strokePath();
    } else {
      const gap = (3 * width) / 2;
      let [x, y] = [Number.NEGATIVE_INFINITY, 0];
      this.stretches.fillStyle(this.colour, 0.7);
      for (let i = 0; i < points.length; i += 2) {
        if (Math.hypot(points[i] - x, points[i + 1] - y) < gap) continue;
        [x, y] = [points[i], points[i + 1]];
        this.stretches.fillCircle(x, y, width / 3);
      }
    }
    // where it begins: a filled diamond if it is proved, else an open one
    const arm = (isShownRun ? 8 : 6) / zoom;
    this.stretches
      .fillStyle(this.colour, 1)
      .lineStyle(2 / zoom, this.colour, 1)
      .beginPath()
      .moveTo(at.x, at.y - arm)
      .lineTo(at.x + arm, at.y)
      .lineTo(at.x, at.y + arm)
      .lineTo(at.x - arm, at.y)
      .closePath();
    if (isProved) this.stretches.fillPath();
    this.stretches.strokePath();
  }
}
