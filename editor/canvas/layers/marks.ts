/** From px of the level to px of a canvas, as the matrix of a camera has it; the camera never turns. */
export interface Lens {
  readonly a: number;
  readonly b: number;
  readonly c: number;
  readonly d: number;
  readonly e: number;
  readonly f: number;
  /** 0 to 1, of all that is seen through it */
  readonly alpha: number;
}

/** The square on the canvas that something can't leave, however it is turned. */
export interface Spot {
  /** its middle */
  x: number;
  y: number;
  /** half of its side */
  reach: number;
}

/** What is painted many times over: things, rings. In the order in which they lie above each other. */
export interface Marks {
  readonly count: number;
  /** Whether what was painted of others may stand for these: they are the same, wherever all of them have been shifted to. */
  looksLike(others: Marks): boolean;
  spotOf(index: number, lens: Lens, into: Spot): Spot;
  /** Paints those from one index up to another. */
  paint(context: CanvasRenderingContext2D, lens: Lens, from: number, to: number): void;
}

const spot: Spot = { x: 0, y: 0, reach: 0 };

/** Whether more of them are seen on a canvas than so many. */
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

/** What all of them cover. */
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
