import { GameObjects, type Scene } from 'phaser';

/** Frames without a change after which a thing counts as standing still. */
const CALM = 10;
/** And after which one that was carried elsewhere does: a hand rests now and then on its way. */
const CALM_ON_THE_WAY = 60;
/** px within which two things have gone the same way: what rounding makes of it. */
const ALIKE = 1e-6;

/** How a thing is drawn: with those that stand still, with those that are dragged, or by itself. */
export type Drawn = 'still' | 'carried' | 'alone';

/** An image that knows how it was drawn last. */
export class Thing extends GameObjects.Image {
  /** As it was sorted last; null: it is new. */
  drawn: Drawn | null = null;
  /** How far it is from where it stood still last, px. */
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
  /** Frames since it was different; all of a level comes at once, and then stands. */
  private calm = CALM;
  /** Whether nothing but its place has changed since it stood still. */
  private onlyMoved = true;

  /** @param restless those that are not known to stand still; it joins them whenever it is changed */
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
    // Phaser calls it while it makes an image
    this.restless?.add(this);
    return super.setTexture(texture);
  }

  override destroy(fromScene?: boolean): void {
    this.restless.delete(this);
    super.destroy(fromScene);
  }

  /** Looks at how it is to be drawn; to be called once a frame while it is restless. */
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

  /** Whether it was taken elsewhere as it is. */
  get isCarried(): boolean {
    return !this.isStill && this.onlyMoved && this.isElsewhere;
  }

  private get isElsewhere(): boolean {
    return this.shiftX !== 0 || this.shiftY !== 0;
  }

  /** Whether it was taken elsewhere as it is, and that far. */
  isCarriedBy(shiftX: number, shiftY: number): boolean {
    return this.isCarried && Math.abs(this.shiftX - shiftX) < ALIKE && Math.abs(this.shiftY - shiftY) < ALIKE;
  }
}
