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
export function areMoreSeen(
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

/** An upright rectangle, px of a canvas. */
export interface Extent {
  readonly left: number;
  readonly top: number;
  readonly right: number;
  readonly bottom: number;
}

/** The area that all marks cover. */
export function extentOf(marks: Marks, lens: Lens): Extent {
  let [left, top, right, bottom] = [
    Number.POSITIVE_INFINITY,
    Number.POSITIVE_INFINITY,
    Number.NEGATIVE_INFINITY,
    Number.NEGATIVE_INFINITY,
  ];
  for (let i = 0; i < marks.count; i++) {
    const { x, y, reach } = marks.spotOf(i, lens, spot);
    left = Math.min(left, x - reach);
    top = Math.min(top, y - reach);
    right = Math.max(right, x + reach);
    bottom = Math.max(bottom, y + reach);
  }
  return { left, top, right, bottom };
}
