import { drawThings, type Lens, type Spot, spotOf } from './draw-things.ts';
import type { Thing } from './thing.ts';

/** Frames in which the things were the same ones, before a picture is made of them. */
const STEADY = 2;
/** Fewer things than this are drawn one by one. */
const WORTHWHILE = 40;
/** px around the canvas that a picture of what is on its way covers. */
const MARGIN = 160;

/** How far things are from where they stood still, px of the level. */
export interface Shift {
  readonly x: number;
  readonly y: number;
}

/** Things as they were drawn once. */
interface Picture {
  /** px of the canvas that its corner lay at */
  readonly left: number;
  readonly top: number;
  /** where the things were then */
  readonly shift: Shift;
  /** px of the canvas that it may be moved by before anything is missing at its edges */
  readonly reach: number;
}

/**
 * Things that stand still, or all go the same way. When they have been the same ones for some frames they are drawn once, onto a picture that is then laid where
 * they are: on whole px of the canvas, so that it stays sharp.
 */
export class Plate {
  private things: readonly Thing[] = [];
  private shown = '';
  /** Frames since either was different. */
  private steady = 0;
  private picture: Picture | null = null;
  private canvas: HTMLCanvasElement | null = null;

  draw(context: CanvasRenderingContext2D, things: readonly Thing[], lens: Lens, shift: Shift): void {
    const { a, b, c, d, e, f, alpha } = lens;
    const { width, height } = context.canvas;
    const shown = [a, b, c, d, e, f, alpha, width, height].join();
    if (shown === this.shown && isSame(things, this.things)) this.steady++;
    else {
      this.steady = 0;
      this.picture = null;
      this.things = things;
      this.shown = shown;
    }
    if (this.steady < STEADY || things.length < WORTHWHILE) {
      drawThings(context, things, lens);
      return;
    }
    const across = ({ x, y }: Shift) => Math.round(a * (shift.x - x) + c * (shift.y - y));
    const down = ({ x, y }: Shift) => Math.round(b * (shift.x - x) + d * (shift.y - y));
    const isGood = (picture: Picture | null): picture is Picture =>
      picture !== null && Math.max(Math.abs(across(picture.shift)), Math.abs(down(picture.shift))) <= picture.reach;
    this.canvas ??= document.createElement('canvas');
    if (!isGood(this.picture)) this.picture = paint(this.canvas, context.canvas, things, lens, shift);
    const { left, top, shift: then } = this.picture;
    context.setTransform(1, 0, 0, 1, 0, 0);
    context.globalAlpha = 1;
    context.drawImage(this.canvas, left + across(then), top + down(then));
  }
}

const isSame = (things: readonly Thing[], before: readonly Thing[]): boolean =>
  things.length === before.length && things.every((thing, i) => thing === before[i]);

/** Draws things onto a canvas that is as large as they are, but no larger than what is seen and a margin. */
function paint(
  canvas: HTMLCanvasElement,
  { width, height }: { readonly width: number; readonly height: number },
  things: readonly Thing[],
  lens: Lens,
  shift: Shift,
): Picture {
  // what stands still is never moved
  const margin = shift.x === 0 && shift.y === 0 ? 0 : MARGIN;
  const box = {
    left: Number.POSITIVE_INFINITY,
    top: Number.POSITIVE_INFINITY,
    right: Number.NEGATIVE_INFINITY,
    bottom: Number.NEGATIVE_INFINITY,
  };
  const spot: Spot = { x: 0, y: 0, reach: 0 };
  for (const thing of things) {
    const { x, y, reach } = spotOf(thing, lens, spot);
    box.left = Math.min(box.left, x - reach);
    box.top = Math.min(box.top, y - reach);
    box.right = Math.max(box.right, x + reach);
    box.bottom = Math.max(box.bottom, y + reach);
  }
  const isWhole = box.left >= -margin && box.top >= -margin && box.right <= width + margin && box.bottom <= height + margin;
  const left = Math.floor(Math.max(box.left, -margin));
  const top = Math.floor(Math.max(box.top, -margin));
  // this clears it, too; one without a px can't be drawn
  canvas.width = Math.max(1, Math.ceil(Math.min(box.right, width + margin)) - left);
  canvas.height = Math.max(1, Math.ceil(Math.min(box.bottom, height + margin)) - top);
  const context = canvas.getContext('2d');
  if (context !== null) drawThings(context, things, { ...lens, e: lens.e - left, f: lens.f - top });
  return { left, top, shift, reach: isWhole ? Number.POSITIVE_INFINITY : margin };
}
