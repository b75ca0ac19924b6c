import { GameObjects, type Scene } from 'phaser';

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
