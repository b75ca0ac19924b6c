import { type Cameras, GameObjects, type Renderer, type Scene } from 'phaser';

type Canvas = Renderer.Canvas.CanvasRenderer;
type Camera = Cameras.Scene2D.Camera;

/** Frames without a change after which a thing counts as standing still. */
const CALM = 10;
/** Frames in which only what moves has changed, before a picture is made of the rest. */
const STEADY = 2;

/** An image of a `StillLayer`, which knows how it was drawn last. */
export class Thing extends GameObjects.Image {
  private drawnX = Number.NaN;
  private drawnY = Number.NaN;
  private drawnRotation = 0;
  private drawnScale = 0;
  private drawnAlpha = 0;
  private drawnFrame: unknown = null;
  /** Frames since it was different; all of a level comes at once, and then stands. */
  private calm = CALM;

  /** To be asked once a frame. */
  isStill(): boolean {
    const { x, y, rotation, scaleX, alpha, frame } = this;
    if (
      this.drawnX === x &&
      this.drawnY === y &&
      this.drawnRotation === rotation &&
      this.drawnScale === scaleX &&
      this.drawnAlpha === alpha &&
      this.drawnFrame === frame
    ) {
      this.calm++;
    } else {
      if (!Number.isNaN(this.drawnX)) this.calm = 0;
      this.drawnX = x;
      this.drawnY = y;
      this.drawnRotation = rotation;
      this.drawnScale = scaleX;
      this.drawnAlpha = alpha;
      this.drawnFrame = frame;
    }
    return this.calm >= CALM;
  }
}

/** Things of neighbouring depths: those that stand still, then those that move, which are drawn above them. */
interface Part {
  readonly still: Thing[];
  readonly moving: Thing[];
}

/** Half of the diagonal of a square, over half of its side. */
const DIAGONAL = Math.SQRT2;

/**
 * Images in the order of their depths. Where a plain canvas is drawn on, those that stand still are drawn once, onto a picture that then stands for them in
 * every frame; of one depth, what moves is above what stands. With a graphics card they are drawn as Phaser draws them: that is faster there.
 */
export class StillLayer extends GameObjects.Layer {
  /** Those of the last frame, and what the camera showed. */
  private parts: readonly Part[] = [];
  private shown = '';
  /** Frames since either was different. */
  private steady = 0;
  /** Of what stands still in each part; null: to be made. */
  private pictures: (HTMLCanvasElement | null)[] = [];
  private spare: HTMLCanvasElement[] = [];

  /** @param worthwhile fewer things than this are drawn one by one: a picture is as large as the canvas */
  constructor(
    scene: Scene,
    private readonly worthwhile: number,
  ) {
    super(scene);
    scene.add.existing(this);
  }

  /** Called by Phaser where there is no graphics card. */
  renderCanvas(renderer: Canvas, _layer: this, camera: Camera): void {
    this.depthSort();
    const context = renderer.currentContext;
    const parts = this.sortOut(camera);
    const { a, b, c, d, e, f } = camera.matrixCombined;
    const shown = [a, b, c, d, e, f, context.canvas.width, context.canvas.height].join();
    this.steady = shown === this.shown && isSame(parts, this.parts) ? this.steady + 1 : 0;
    if (this.steady === 0) this.forgetPictures();
    this.parts = parts;
    this.shown = shown;
    context.save();
    for (const [i, { still, moving }] of parts.entries()) {
      if (this.steady < STEADY || still.length < this.worthwhile) draw(context, still, camera);
      else {
        context.setTransform(1, 0, 0, 1, 0, 0);
        context.globalAlpha = 1;
        context.drawImage(this.pictureOf(i, still, context.canvas, camera), 0, 0);
      }
      draw(context, moving, camera);
    }
    context.restore();
  }

  private sortOut(camera: Camera): Part[] {
    const parts: Part[] = [];
    let part: Part = { still: [], moving: [] };
    let depth = Number.NaN;
    for (const thing of this.getChildren() as Thing[]) {
      // what lies higher may only be put into the same picture as long as nothing moves between
      if (thing.depth !== depth && part.moving.length > 0) {
        parts.push(part);
        part = { still: [], moving: [] };
      }
      depth = thing.depth;
      if (!thing.willRender(camera)) continue;
      (thing.isStill() ? part.still : part.moving).push(thing);
    }
    parts.push(part);
    return parts;
  }

  private pictureOf(index: number, things: readonly Thing[], { width, height }: HTMLCanvasElement, camera: Camera) {
    const made = this.pictures[index];
    if (made != null) return made;
    const picture = this.spare.pop() ?? document.createElement('canvas');
    // this clears it, too
    picture.width = width;
    picture.height = height;
    this.pictures[index] = picture;
    const context = picture.getContext('2d');
    if (context !== null) draw(context, things, camera);
    return picture;
  }

  private forgetPictures(): void {
    for (const picture of this.pictures) if (picture != null) this.spare.push(picture);
    this.pictures = [];
  }
}

function isSame(parts: readonly Part[], before: readonly Part[]): boolean {
  if (parts.length !== before.length) return false;
  return parts.every(({ still }, i) => {
    const old = before[i].still;
    return still.length === old.length && still.every((thing, k) => thing === old[k]);
  });
}

/**
 * Draws things as Phaser's canvas renderer does. It saves and sets all of the canvas's state for each of them, which for a thousand takes longer than to draw them;
 * and it draws what is out of sight.
 */
function draw(context: CanvasRenderingContext2D, things: readonly Thing[], camera: Camera): void {
  const { a, b, c, d, e, f } = camera.matrixCombined;
  const { width, height } = context.canvas;
  const zoom = Math.max(Math.hypot(a, b), Math.hypot(c, d));
  for (const thing of things) {
    const { x, y, rotation, scaleX, scaleY, displayOriginX, displayOriginY, frame } = thing;
    const alpha = camera.alpha * thing.alpha;
    const left = a * x + c * y + e;
    const top = b * x + d * y + f;
    const reach = DIAGONAL * zoom * Math.max(displayOriginX * Math.abs(scaleX), displayOriginY * Math.abs(scaleY));
    if (alpha === 0 || left + reach < 0 || left - reach > width || top + reach < 0 || top - reach > height) continue;
    const cos = Math.cos(rotation);
    const sin = Math.sin(rotation);
    context.setTransform(
      (a * cos + c * sin) * scaleX,
      (b * cos + d * sin) * scaleX,
      (c * cos - a * sin) * scaleY,
      (d * cos - b * sin) * scaleY,
      left,
      top,
    );
    context.globalAlpha = alpha;
    context.drawImage(frame.source.image as HTMLCanvasElement, -displayOriginX, -displayOriginY);
  }
}
