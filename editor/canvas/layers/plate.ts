import type { Box } from '../view.ts';

/** frames in which the marks must stay the same before a picture is made */
const STEADY = 2;
/** fewer marks than this are painted directly */
const WORTHWHILE = 40;
/**
 * Up to this many visible marks are painted directly while the view moves: they are large then, and a stretched picture would
 * look blurred.
 */
const FEW = 300;
/** frames after which a view counts as at rest: then a sharp picture is made */
const REST = 4;
/** marks painted per frame at most, while an older picture can be shown instead */
const AT_ONCE = 500;
/** px around the canvas that a picture of moving marks covers */
const MARGIN = 160;

/** How far marks are from where they were at rest, px of the level. */
export interface Shift {
  readonly x: number;
  readonly y: number;
}

interface Size {
  readonly width: number;
  readonly height: number;
}

/** A picture of marks. */
interface Picture {
  readonly canvas: HTMLCanvasElement;
  /** the transformation with which they were painted */
  readonly lens: Lens;
  /** size of the canvas that the picture was made for */
  readonly size: Size;
  /** px of the lens's canvas at the picture's corner */
  readonly left: number;
  readonly top: number;
  /** the shift of the marks when they were painted */
  readonly shift: Shift;
  /** px of the canvas by which it can be moved before something is missing at its edges */
  readonly reach: number;
  /** Whether it contains all marks. */
  readonly isWhole: boolean;
  /** index of the first mark that is not painted yet */
  next: number;
}

const isSameLens = (one: Lens, other: Lens): boolean =>
  one.a === other.a &&
  one.b === other.b &&
  one.c === other.c &&
  one.d === other.d &&
  one.e === other.e &&
  one.f === other.f &&
  one.alpha === other.alpha;

const isSameSize = (one: Size, other: Size): boolean => one.width === other.width && one.height === other.height;

/**
 * Marks at rest, or moving by the same shift, for the canvas renderer. Once they have stayed the same for some frames, they are
 * painted to a picture, which is then drawn at whole px of the canvas, so that it stays sharp. While the view moves, the last
 * picture is stretched, or one that contains all marks. Once the view rests, a sharp picture is made, a few marks per frame, so
 * that no frame takes long.
 */
export class Plate {
  private marks: Marks | null = null;
  private lens: Lens | null = null;
  private size: Size = { width: 0, height: 0 };
  /** frames since the marks changed */
  private steady = 0;
  /** frames since the view moved */
  private rested = 0;
  private sharp: Picture | null = null;
  private whole: Picture | null = null;
  private making: Picture | null = null;
  private readonly canvases: HTMLCanvasElement[] = [];

  /** @param shift how far all marks have moved since they were at rest */
  draw(context: CanvasRenderingContext2D, marks: Marks, lens: Lens, shift: Shift): void {
    this.look(marks, lens, context.canvas);
    const picture = this.steady < STEADY || marks.count < WORTHWHILE ? null : this.pictureOf(marks, lens, shift);
    if (picture === null) marks.paint(context, lens, 0, marks.count);
    else lay(context, picture, lens, shift);
  }

  private look(marks: Marks, lens: Lens, { width, height }: Size): void {
    // The first marks are expected to stay: painting thousands of them directly in the first frames as well would take long.
    if (this.marks === null) this.steady = STEADY;
    else if (marks.looksLike(this.marks)) this.steady++;
    else {
      this.steady = 0;
      this.sharp = null;
      this.whole = null;
      this.making = null;
    }
    this.marks = marks;
    const isResting = this.lens !== null && isSameLens(this.lens, lens) && isSameSize(this.size, { width, height });
    this.rested = isResting ? this.rested + 1 : 0;
    this.lens = lens;
    this.size = { width, height };
  }

  /** The picture to draw instead of the marks; null if painting the marks is better. */
  private pictureOf(marks: Marks, lens: Lens, shift: Shift): Picture | null {
    const { sharp, size } = this;
    if (sharp !== null && isSameLens(sharp.lens, lens) && isSameSize(sharp.size, size) && reaches(sharp, lens, shift)) {
      // make the picture that is shown when the view moves ahead of time
      if (this.whole === null && isAt(sharp, shift)) this.makeWhole(marks, lens, shift);
      return sharp;
    }
    const standIn = this.whole !== null && isAt(this.whole, shift) ? this.whole : sharp;
    if (standIn === null || !isAt(standIn, shift)) {
      this.sharp = this.begun(lens, shift, this.clipped(marks, lens, shift));
      paintMore(this.sharp, marks, Number.POSITIVE_INFINITY);
      if (this.sharp.isWhole) this.whole = this.sharp;
      return this.sharp;
    }
    if (!areMoreSeen(marks, lens, size, FEW)) return null;
    if (this.rested < REST) {
      if (this.whole === null) this.makeWhole(marks, lens, shift);
      return standIn;
    }
    const { making } = this;
    const isOfNow = making !== null && isSameLens(making.lens, lens) && isAt(making, shift) && isSameSize(making.size, size);
    this.making = isOfNow ? making : this.begun(lens, shift, this.clipped(marks, lens, shift));
    if (!paintMore(this.making, marks, AT_ONCE)) return standIn;
    this.sharp = this.making;
    this.making = null;
    if (this.sharp.isWhole) this.whole = this.sharp;
    return this.sharp;
  }

  /** Continues a picture of all marks, no larger than the canvas. */
  private makeWhole(marks: Marks, lens: Lens, shift: Shift): void {
    if (this.making === null || !this.making.isWhole || !isAt(this.making, shift)) {
      const { left, top, right, bottom } = areaOf(marks, lens);
      const share = Math.min(1, this.size.width / (right - left), this.size.height / (bottom - top));
      const { a, b, c, d, e, f, alpha } = lens;
      const far = { a: a * share, b: b * share, c: c * share, d: d * share, e: (e - left) * share, f: (f - top) * share, alpha };
      const box = { left: 0, top: 0, width: (right - left) * share, height: (bottom - top) * share };
      this.making = this.begun(far, shift, { ...box, reach: 0, isWhole: true });
    }
    if (!paintMore(this.making, marks, AT_ONCE)) return;
    this.whole = this.making;
    this.making = null;
  }

  /** The visible part of the marks, with a margin if they move. */
  private clipped(marks: Marks, lens: Lens, shift: Shift): Clip {
    const { width, height } = this.size;
    // marks at rest need no margin
    const margin = shift.x === 0 && shift.y === 0 ? 0 : MARGIN;
    const box = areaOf(marks, lens);
    const isWhole = box.left >= -margin && box.top >= -margin && box.right <= width + margin && box.bottom <= height + margin;
    const left = Math.floor(Math.max(box.left, -margin));
    const top = Math.floor(Math.max(box.top, -margin));
    return {
      left,
      top,
      width: Math.ceil(Math.min(box.right, width + margin)) - left,
      height: Math.ceil(Math.min(box.bottom, height + margin)) - top,
      reach: isWhole ? Number.POSITIVE_INFINITY : margin,
      isWhole,
    };
  }

  /** An empty picture. */
  private begun(lens: Lens, shift: Shift, { left, top, width, height, reach, isWhole }: Clip): Picture {
    const used = [this.sharp?.canvas, this.whole?.canvas];
    let canvas = this.canvases.find((one) => !used.includes(one));
    if (canvas === undefined) {
      canvas = document.createElement('canvas');
      this.canvases.push(canvas);
    }
    // setting the size clears the canvas; a canvas without px can't be drawn
    canvas.width = Math.max(1, Math.ceil(width));
    canvas.height = Math.max(1, Math.ceil(height));
    return { canvas, lens, size: this.size, left, top, shift, reach, isWhole, next: 0 };
  }
}

/** The part of a lens's canvas that a picture shows, px. */
interface Clip extends Pick<Picture, 'left' | 'top' | 'reach' | 'isWhole'>, Size {}

/** Whether the marks are where they were when the picture was painted. */
const isAt = ({ shift }: Picture, { x, y }: Shift): boolean => shift.x === x && shift.y === y;

/** How far the marks have moved since a picture was painted, in whole px of the canvas. */
const wayOf = ({ shift: then }: Picture, { a, b, c, d }: Lens, shift: Shift): Shift => ({
  x: Math.round(a * (shift.x - then.x) + c * (shift.y - then.y)),
  y: Math.round(b * (shift.x - then.x) + d * (shift.y - then.y)),
});

/** Whether nothing is missing at its edges. */
function reaches(picture: Picture, lens: Lens, shift: Shift): boolean {
  const { x, y } = wayOf(picture, lens, shift);
  return Math.max(Math.abs(x), Math.abs(y)) <= picture.reach;
}

/** Paints more of the marks. @returns whether all of them are painted */
function paintMore(picture: Picture, marks: Marks, most: number): boolean {
  const to = Math.min(marks.count, picture.next + most);
  const { lens, left, top, canvas } = picture;
  const context = canvas.getContext('2d');
  if (context !== null) marks.paint(context, { ...lens, e: lens.e - left, f: lens.f - top }, picture.next, to);
  picture.next = to;
  return to === marks.count;
}

/** Draws a picture where the marks are now, stretched if it was painted for another view. */
function lay(context: CanvasRenderingContext2D, picture: Picture, lens: Lens, shift: Shift): void {
  const { canvas, left, top } = picture;
  context.globalAlpha = 1;
  const way = wayOf(picture, lens, shift);
  if (isSameLens(picture.lens, lens)) {
    context.setTransform(1, 0, 0, 1, 0, 0);
    context.drawImage(canvas, left + way.x, top + way.y);
    return;
  }
  const grown = lens.a / picture.lens.a;
  context.setTransform(
    grown,
    0,
    0,
    grown,
    grown * (left - picture.lens.e) + lens.e + way.x,
    grown * (top - picture.lens.f) + lens.f + way.y,
  );
  context.drawImage(canvas, 0, 0);
}

/** From px of the level to px of a canvas, as a camera's matrix; the camera never rotates. */
export interface Lens {
  readonly a: number;
  readonly b: number;
  readonly c: number;
  readonly d: number;
  readonly e: number;
  readonly f: number;
  /** 0 to 1, for everything */
  readonly alpha: number;
}

/** The square on the canvas that contains a mark at any rotation. */
export interface Spot {
  /** its centre */
  x: number;
  y: number;
  /** half of its side */
  reach: number;
}

/** Many things to paint alike: images, rings. Ordered from below to above. */
export interface Marks {
  readonly count: number;
  /** Whether a picture of other marks can be used for these: they are the same, up to a common shift. */
  looksLike(others: Marks): boolean;
  spotOf(index: number, lens: Lens, into: Spot): Spot;
  /** Paints the marks from one index up to another, exclusive. */
  paint(context: CanvasRenderingContext2D, lens: Lens, from: number, to: number): void;
}

const spot: Spot = { x: 0, y: 0, reach: 0 };

/** Whether more than `few` of the marks are visible on a canvas. */
function areMoreSeen(
  marks: Marks,
  lens: Lens,
  { width, height }: { readonly width: number; readonly height: number },
  few: number,
): boolean {
  let seen = 0;
  for (let i = 0; i < marks.count; i++) {
    const { x, y, reach } = marks.spotOf(i, lens, spot);
    if (x + reach >= 0 && x - reach <= width && y + reach >= 0 && y - reach <= height && ++seen > few) return true;
  }
  return false;
}

/** The area that all marks cover, px of the canvas. */
function areaOf(marks: Marks, lens: Lens): Box {
  const far = Number.POSITIVE_INFINITY;
  let [left, top, right, bottom] = [far, far, -far, -far];
  for (let i = 0; i < marks.count; i++) {
    const { x, y, reach } = marks.spotOf(i, lens, spot);
    left = Math.min(left, x - reach);
    top = Math.min(top, y - reach);
    right = Math.max(right, x + reach);
    bottom = Math.max(bottom, y + reach);
  }
  return { left, top, right, bottom };
}
