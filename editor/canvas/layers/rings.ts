import { type Cameras, GameObjects, type Renderer, type Scene, WEBGL } from 'phaser';
import type { Disc } from '../../../schema/index.ts';
import { type Lens, type Marks, Plate, type Shift, type Spot } from './plate.ts';

type Canvas = Renderer.Canvas.CanvasRenderer;
type Camera = Cameras.Scene2D.Camera;

/** The look of rings, independent of the zoom. */
export interface RingLook {
  readonly colour: number;
  readonly alpha: number;
  /** px of screen */
  readonly width: number;
  /** px of screen by which the rings are larger than their circles */
  readonly off: number;
}

const NOWHERE: Shift = { x: 0, y: 0 };
/** px within which two shifts count as equal: rounding errors */
const ALIKE = 1e-6;

class RingMarks implements Marks {
  constructor(
    private readonly circles: readonly Disc[],
    private readonly shift: Shift,
    private readonly look: RingLook,
  ) {}

  get count(): number {
    return this.circles.length;
  }

  looksLike(others: Marks): boolean {
    return others instanceof RingMarks && others.circles === this.circles;
  }

  spotOf(index: number, { a, c, b, d, e, f }: Lens, into: Spot): Spot {
    const { x, y, radius } = this.circles[index];
    const atX = x + this.shift.x;
    const atY = y + this.shift.y;
    into.x = a * atX + c * atY + e;
    into.y = b * atX + d * atY + f;
    into.reach = a * radius + this.look.off + this.look.width;
    return into;
  }

  paint(context: CanvasRenderingContext2D, lens: Lens, from: number, to: number): void {
    const { width, height } = context.canvas;
    const { colour, alpha, width: line, off } = this.look;
    const spot: Spot = { x: 0, y: 0, reach: 0 };
    context.setTransform(1, 0, 0, 1, 0, 0);
    context.globalAlpha = lens.alpha * alpha;
    context.strokeStyle = `#${colour.toString(16).padStart(6, '0')}`;
    context.lineWidth = line;
    context.beginPath();
    for (let i = from; i < to; i++) {
      const { x, y, reach } = this.spotOf(i, lens, spot);
      if (x + reach < 0 || x - reach > width || y + reach < 0 || y - reach > height) continue;
      const radius = lens.a * this.circles[i].radius + off;
      context.moveTo(x + radius, y);
      context.arc(x, y, radius, 0, 2 * Math.PI);
    }
    context.stroke();
  }
}

/** How far all circles have moved, if they are the same ones; else null. */
function shiftBetween(now: readonly Disc[], then: readonly Disc[]): Shift | null {
  if (now.length !== then.length || now.length === 0) return null;
  const x = now[0].x - then[0].x;
  const y = now[0].y - then[0].y;
  const isAlike = now.every((circle, i) => {
    const was = then[i];
    return circle.radius === was.radius && Math.abs(circle.x - was.x - x) < ALIKE && Math.abs(circle.y - was.y - y) < ALIKE;
  });
  return isAlike ? { x, y } : null;
}

/**
 * Thousands of rings of one look. With the canvas renderer they are painted once to a picture, which is then drawn at their
 * place.
 */
export class Rings extends GameObjects.Graphics {
  /** The circles as they were last painted, and how far all of them have moved since. */
  private circles: readonly Disc[] = [];
  private shift = NOWHERE;
  private look: RingLook = { colour: 0, alpha: 0, width: 0, off: 0 };
  /** the zoom for which Phaser's commands were made */
  private zoom = Number.NaN;
  private readonly plate = new Plate();
  private readonly isWebgl: boolean;

  constructor(scene: Scene) {
    super(scene);
    scene.add.existing(this);
    this.isWebgl = scene.sys.renderer.type === WEBGL;
  }

  /** @param zoom px of screen per px of the level */
  show(circles: readonly Disc[], look: RingLook, zoom: number): void {
    const { alpha, colour, off, width } = this.look;
    const looksSame = look.alpha === alpha && look.colour === colour && look.off === off && look.width === width;
    const shift = looksSame ? shiftBetween(circles, this.circles) : null;
    if (shift === null) this.circles = circles;
    this.shift = shift ?? NOWHERE;
    this.look = look;
    this.zoom = Number.NaN;
    this.zoomTo(zoom);
  }

  /** Keeps their look at another zoom. */
  zoomTo(zoom: number): void {
    if (!this.isWebgl || zoom === this.zoom) return;
    this.zoom = zoom;
    this.command(zoom);
  }

  /** Called by Phaser's canvas renderer. */
  renderCanvas(renderer: Canvas, _rings: this, camera: Camera): void {
    if (this.circles.length === 0) return;
    const { a, b, c, d, e, f } = camera.matrixCombined;
    const context = renderer.currentContext;
    context.save();
    const marks = new RingMarks(this.circles, this.shift, this.look);
    this.plate.draw(context, marks, { a, b, c, d, e, f, alpha: camera.alpha }, this.shift);
    context.restore();
  }

  private command(zoom: number): void {
    const { colour, alpha, width, off } = this.look;
    this.clear();
    if (this.circles.length === 0) return;
    this.lineStyle(width / zoom, colour, alpha).beginPath();
    for (const { x, y, radius } of this.circles) {
      const [atX, atY, out] = [x + this.shift.x, y + this.shift.y, radius + off / zoom];
      this.moveTo(atX + out, atY).arc(atX, atY, out, 0, 2 * Math.PI);
    }
    this.strokePath();
  }
}
