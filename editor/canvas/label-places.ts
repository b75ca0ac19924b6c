import { reasonInWords } from '../../check/words/index.ts';
import { STATE_SIZE } from '../../engine/index.ts';
import { isWhole, type LiveProof } from '../core/proof/index.ts';
import { type Point, toScreen, type View } from './view.ts';

interface Size {
  readonly width: number;
  readonly height: number;
}

/** px of screen from the point to its label */
const BESIDE = 16;
/** px of screen from a label to the edges of the view */
const MARGIN = 8;
/** the same to its upper edge, along which the tools stand */
const BELOW_TOOLS = 56;

/** The sides of a point on which its label can be, the best first: how far each shifts the label, in parts of its size. */
const SIDES = [
  { across: 0.5, along: 0 },
  { across: -0.5, along: 0 },
  { across: 0, along: 0.5 },
  { across: 0, along: -0.5 },
] as const;

/**
 * Finds a place for a label beside a point, within the view, on the side where it covers least. All lengths are px of screen.
 * @param label size of the label
 * @param covered points that the label should not cover
 * @returns the label's centre
 */
export function labelPlace(point: Point, label: Size, view: Size, covered: readonly Point[]): Point {
  const within = (value: number, half: number, size: number, first = MARGIN) =>
    Math.max(half + first, Math.min(size - half - MARGIN, value));
  const [halfWidth, halfHeight] = [label.width / 2, label.height / 2];
  let best = point;
  let least = Number.POSITIVE_INFINITY;
  for (const { across, along } of SIDES) {
    const x = within(point.x + across * (label.width + 2 * BESIDE), halfWidth, view.width);
    const y = within(point.y + along * (label.height + 2 * BESIDE), halfHeight, view.height, BELOW_TOOLS);
    const covers = (other: Point) => Math.abs(other.x - x) < halfWidth && Math.abs(other.y - y) < halfHeight;
    // the point itself is covered only where the view has too little room on this side
    const count = covered.filter(covers).length + (covers(point) ? covered.length + 1 : 0);
    if (count >= least) continue;
    least = count;
    best = { x, y };
  }
  return best;
}

/** greatest width of a label in px, repeated in `canvas.css` */
const WIDEST = 232;
/** px: a line of text, and what stands around all lines */
const [LINE, AROUND] = [18, 10];
/** ticks between the points of the way that a label should not cover */
const EACH = 12;
/** px between the points of another label that a label should not cover */
const GRAIN = 12;

const sizeOf = (words: string) => {
  const width = 18 + 7 * words.length;
  return { width: Math.min(WIDEST, width), height: AROUND + LINE * Math.ceil(width / WIDEST) };
};

/** Why the shown run fails; null if it does not, or is not known to. */
export const reasonOf = (proof: LiveProof): string | null =>
  isWhole(proof) ? reasonInWords(proof.run, proof.level.range) : null;

/** Points of a way, px of the screen. */
export function pointsOfWay({ states, count }: LiveProof['run']['way'], view: View): Point[] {
  const points = [];
  for (let k = 0; k < count; k += EACH) {
    points.push(toScreen(view, { x: states[k * STATE_SIZE], y: states[k * STATE_SIZE + 1] }));
  }
  return points;
}

/** Where the reason stands, its centre in px of the screen. @param at the end of the run, px of the level */
export const reasonPlace = (words: string, at: Point, way: LiveProof['run']['way'], view: View): Point =>
  labelPlace(toScreen(view, at), sizeOf(words), view, pointsOfWay(way, view));

/**
 * Where a label at a moment of the run stands, beside the reason at its end.
 * @param at px of the level
 * @param reason why the run fails; null: it says nothing
 * @param end of the run, px of the level
 */
export function momentPlace(
  words: string,
  at: Point,
  { reason, end, way }: { readonly reason: string | null; readonly end: Point; readonly way: LiveProof['run']['way'] },
  view: View,
): Point {
  const covered = pointsOfWay(way, view);
  if (reason !== null) {
    const place = reasonPlace(reason, end, way, view);
    const { width, height } = sizeOf(reason);
    // a few points weigh more than all of the way
    for (let x = place.x - width / 2; x <= place.x + width / 2; x += GRAIN) {
      for (let y = place.y - height / 2; y <= place.y + height / 2; y += GRAIN) covered.push({ x, y });
    }
  }
  return labelPlace(toScreen(view, at), sizeOf(words), view, covered);
}
