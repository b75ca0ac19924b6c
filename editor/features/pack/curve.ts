import type { Card } from './pack-model.ts';

/** A level on the curve. */
export interface CurvePoint {
  readonly card: Card;
  /** px from the left and from the top */
  readonly x: number;
  readonly y: number;
}

/** The curve of difficulty as a drawing. */
export interface Curve {
  readonly points: readonly CurvePoint[];
  /** Lines through levels that follow one another, as points of an SVG polyline. */
  readonly lines: readonly string[];
}

/** px around the drawing: on the left there is room for the grades */
export const MARGIN = { left: 26, right: 10, top: 16, bottom: 18 } as const;

const GRADES = { least: 1, most: 10 } as const;

/** Where a grade stands, px from the top. */
export const heightOf = (grade: number, height: number): number =>
  MARGIN.top + ((GRADES.most - grade) / (GRADES.most - GRADES.least)) * (height - MARGIN.top - MARGIN.bottom);

/** Lays the listed levels out by place and grade; a level without a grade is a gap in the line. */
export function curveOf(cards: readonly Card[], width: number, height: number): Curve {
  const listed = cards.filter(({ isListed }) => isListed);
  const step = (width - MARGIN.left - MARGIN.right) / Math.max(1, listed.length - 1);
  const points: CurvePoint[] = [];
  const lines: string[][] = [[]];
  for (const [i, card] of listed.entries()) {
    const grade = card.grade?.value ?? null;
    if (grade === null) {
      lines.push([]);
      continue;
    }
    const point = { card, x: MARGIN.left + i * step, y: heightOf(grade, height) };
    points.push(point);
    lines.at(-1)?.push(`${point.x.toFixed(1)},${point.y.toFixed(1)}`);
  }
  return { points, lines: lines.filter((line) => line.length > 1).map((line) => line.join(' ')) };
}
