import type { GameObjects, Scene } from 'phaser';
import { type Colours, colourNumber, type Drawing, dashesOf, type Frame, linesOf, Rings } from '../../canvas/index.ts';
import type { OnionPicture } from './onion-picture.ts';

/** px of screen of a dash and of the gap after it */
const DASH = 6;
/** px of screen from the middle of the mark at the end to its corners */
const MARK = 6;

/** The level as it was before a change: the way of the run, dashed, with a mark at its end; outlines, and lines from there. */
export class OnionLayer implements Drawing<OnionPicture | null> {
  private readonly way: GameObjects.Graphics;
  private readonly links: GameObjects.Graphics;
  private readonly outlines: Rings;
  private readonly colour: number;
  /** what the way was last drawn from */
  private drawn: { readonly points: Float32Array; readonly zoom: number } | null = null;

  constructor(scene: Scene, colours: Colours) {
    this.way = scene.add.graphics().setDepth(7.4);
    this.links = scene.add.graphics().setDepth(18);
    this.outlines = new Rings(scene).setDepth(18);
    this.colour = colourNumber(colours.onion);
  }

  /** @param picture null: nothing is shown */
  show(picture: OnionPicture | null, { zoom }: Frame): void {
    this.links.clear();
    this.outlines.show(picture?.discs ?? [], { colour: this.colour, alpha: 0.9, width: 1.2, off: 0 }, zoom);
    if (picture === null) {
      this.way.clear();
      this.drawn = null;
      return;
    }
    this.trace(picture.points, zoom);
    this.links.lineStyle(1.2 / zoom, this.colour, 0.9);
    if (picture.start !== null) {
      const { x, y } = picture.start;
      const { halfWidth, halfHeight } = picture.her;
      this.links.strokeRect(x - halfWidth, y - halfHeight, 2 * halfWidth, 2 * halfHeight);
    }
    if (picture.extent !== null) {
      const { left, top, right, bottom } = picture.extent;
      this.links.strokeRect(left, top, right - left, bottom - top);
    }
    this.links.beginPath();
    for (const { from, to } of picture.links) this.links.moveTo(from.x, from.y).lineTo(to.x, to.y);
    this.links.strokePath();
  }

  destroy(): void {
    this.way.destroy();
    this.links.destroy();
    this.outlines.destroy();
  }

  /** It stays the same for as long as an object is dragged. */
  private trace(points: Float32Array, zoom: number): void {
    if (this.drawn?.points === points && this.drawn.zoom === zoom) return;
    this.drawn = { points, zoom };
    this.way
      .clear()
      .lineStyle(1.6 / zoom, this.colour, 0.95)
      .beginPath();
    for (const dash of dashesOf(linesOf(points), DASH / zoom)) {
      this.way.moveTo(dash[0], dash[1]);
      for (let i = 2; i < dash.length; i += 2) this.way.lineTo(dash[i], dash[i + 1]);
    }
    this.way.strokePath();
    const [x, y] = points.subarray(points.length - 2);
    const arm = MARK / zoom;
    this.way.lineStyle(2 / zoom, this.colour, 1).strokePoints(
      [
        { x, y: y - arm },
        { x: x + arm, y },
        { x, y: y + arm },
        { x: x - arm, y },
      ] as never,
      true,
      true,
    );
  }
}
