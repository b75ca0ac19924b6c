import { GameObjects, type Scene } from 'phaser';
import type { Lens, Marks, Spot } from './plate.ts';

/** frames without a change after which a thing counts as at rest */
const CALM = 10;
/** the same for a thing that was carried elsewhere: the hand may pause during a drag */
const CALM_ON_THE_WAY = 60;
/** px within which two shifts count as equal: rounding errors */
const ALIKE = 1e-6;

/** How a thing is drawn: with those at rest, with those that are dragged, or by itself. */
export type Drawn = 'still' | 'carried' | 'alone';

/** An image that knows how it was last drawn. */
export class Thing extends GameObjects.Image {
  /** How it was last sorted; null: it is new. */
  drawn: Drawn | null = null;
  /** How far it is from where it was last at rest, px. */
  shiftX = 0;
  shiftY = 0;
  private standsX = Number.NaN;
  private standsY = Number.NaN;
  private drawnX = Number.NaN;
  private drawnY = Number.NaN;
  private drawnRotation = 0;
  private drawnScale = 0;
  private drawnAlpha = 0;
  private drawnFrame: unknown = null;
  /** Frames since it changed. It starts at rest, as all images of a level appear at once and stay. */
  private calm = CALM;
  /** Whether only its position has changed since it was at rest. */
  private onlyMoved = true;

  /** @param restless the things that may not be at rest; a thing joins them whenever it changes */
  constructor(
    scene: Scene,
    texture: string,
    private readonly restless: Set<Thing>,
  ) {
    super(scene, 0, 0, texture);
    restless.add(this);
  }

  override setPosition(x: number, y: number): this {
    if (x === this.x && y === this.y) return this;
    this.restless.add(this);
    return super.setPosition(x, y);
  }

  override setRotation(radians: number): this {
    this.restless.add(this);
    return super.setRotation(radians);
  }

  override setScale(scale: number): this {
    this.restless.add(this);
    return super.setScale(scale);
  }

  override setAlpha(alpha: number): this {
    if (alpha === this.alpha) return this;
    this.restless.add(this);
    return super.setAlpha(alpha);
  }

  override setTexture(texture: string): this {
    // Phaser also calls this in the constructor.
    this.restless?.add(this);
    return super.setTexture(texture);
  }

  override destroy(fromScene?: boolean): void {
    this.restless.delete(this);
    super.destroy(fromScene);
  }

  /** Updates how it is to be drawn; called once per frame while it is restless. */
  look(): void {
    const { x, y, rotation, scaleX, alpha, frame } = this;
    const isNew = Number.isNaN(this.drawnX);
    const looksSame =
      this.drawnRotation === rotation && this.drawnScale === scaleX && this.drawnAlpha === alpha && this.drawnFrame === frame;
    if (looksSame && this.drawnX === x && this.drawnY === y) this.calm++;
    else if (!isNew) {
      this.calm = 0;
      this.onlyMoved &&= looksSame;
    }
    this.drawnX = x;
    this.drawnY = y;
    this.drawnRotation = rotation;
    this.drawnScale = scaleX;
    this.drawnAlpha = alpha;
    this.drawnFrame = frame;
    if (isNew) [this.standsX, this.standsY] = [x, y];
    this.shiftX = x - this.standsX;
    this.shiftY = y - this.standsY;
    if (!this.isStill) return;
    [this.standsX, this.standsY, this.shiftX, this.shiftY] = [x, y, 0, 0];
    this.onlyMoved = true;
  }

  get isStill(): boolean {
    return this.calm >= (this.onlyMoved && this.isElsewhere ? CALM_ON_THE_WAY : CALM);
  }

  /** Whether it was moved without any other change. */
  get isCarried(): boolean {
    return !this.isStill && this.onlyMoved && this.isElsewhere;
  }

  private get isElsewhere(): boolean {
    return this.shiftX !== 0 || this.shiftY !== 0;
  }

  /** Whether it was moved by this shift without any other change. */
  isCarriedBy(shiftX: number, shiftY: number): boolean {
    return this.isCarried && Math.abs(this.shiftX - shiftX) < ALIKE && Math.abs(this.shiftY - shiftY) < ALIKE;
  }
}

/** half of the diagonal of a square over half of its side */
const DIAGONAL = Math.SQRT2;

function spotOf(thing: Thing, { a, b, c, d, e, f }: Lens, into: Spot): Spot {
  const { x, y, scaleX, scaleY, displayOriginX, displayOriginY } = thing;
  const zoom = Math.max(Math.sqrt(a * a + b * b), Math.sqrt(c * c + d * d));
  into.x = a * x + c * y + e;
  into.y = b * x + d * y + f;
  into.reach = DIAGONAL * zoom * Math.max(displayOriginX * Math.abs(scaleX), displayOriginY * Math.abs(scaleY));
  return into;
}

/**
 * Draws things like Phaser's canvas renderer, but faster: for each thing, Phaser saves and sets the whole state of the canvas,
 * which takes longer than the drawing itself, and it also draws what is not visible.
 */
function drawThings(context: CanvasRenderingContext2D, things: readonly Thing[], lens: Lens, from: number, to: number): void {
  const { a, b, c, d } = lens;
  const { width, height } = context.canvas;
  const spot: Spot = { x: 0, y: 0, reach: 0 };
  for (let i = from; i < to; i++) {
    const thing = things[i];
    const { rotation, scaleX, scaleY, displayOriginX, displayOriginY, frame } = thing;
    const alpha = lens.alpha * thing.alpha;
    const { x, y, reach } = spotOf(thing, lens, spot);
    if (alpha === 0 || x + reach < 0 || x - reach > width || y + reach < 0 || y - reach > height) continue;
    const cos = Math.cos(rotation);
    const sin = Math.sin(rotation);
    context.setTransform(
      (a * cos + c * sin) * scaleX,
      (b * cos + d * sin) * scaleX,
      (c * cos - a * sin) * scaleY,
      (d * cos - b * sin) * scaleY,
      x,
      y,
    );
    context.globalAlpha = alpha;
    context.drawImage(frame.source.image as HTMLCanvasElement, -displayOriginX, -displayOriginY);
  }
}

/** Images, painted without Phaser. */
export class Things implements Marks {
  constructor(private readonly things: readonly Thing[]) {}

  get count(): number {
    return this.things.length;
  }

  looksLike(others: Marks): boolean {
    if (others === this) return true;
    if (!(others instanceof Things) || others.count !== this.count) return false;
    return this.things.every((thing, i) => thing === others.things[i]);
  }

  spotOf(index: number, lens: Lens, into: Spot): Spot {
    return spotOf(this.things[index], lens, into);
  }

  paint(context: CanvasRenderingContext2D, lens: Lens, from: number, to: number): void {
    drawThings(context, this.things, lens, from, to);
  }
}
