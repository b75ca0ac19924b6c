import { useEffect, useRef, useState } from 'react';
import { JUMP } from '../../../check/pack/index.ts';
import type { Card } from './pack-model.ts';

/** px */
const HEIGHT = 132;

/** Grades at which there is a line. */
const LINES = [1, 4, 7, 10] as const;

function useWidth() {
  const element = useRef<HTMLDivElement>(null);
  const [width, setWidth] = useState(0);
  useEffect(() => {
    if (element.current === null) return;
    const observer = new ResizeObserver(([{ contentRect }]) => setWidth(Math.round(contentRect.width)));
    observer.observe(element.current);
    return () => observer.disconnect();
  }, []);
  return { element, width };
}

/** The curve of difficulty: the grade of each level by its place, as a drawing and as a table. */
export function PackCurve({ cards, onGo }: { readonly cards: readonly Card[]; readonly onGo: (card: Card) => void }) {
  const { element, width } = useWidth();
  const { points, lines } = curveOf(cards, width, HEIGHT);
  const jumps = points.filter(({ card }) => card.jump !== null);
  return (
    <figure className="pack__curve">
      <figcaption>
        <span className="pack__heading">Difficulty by place</span>
        <span className="pack__note">
          {points.length === 0
            ? 'No grade is measured yet.'
            : `${points.length} of ${cards.length} measured. ${jumpsInWords(jumps.map(({ card }) => card.number))}`}
        </span>
      </figcaption>
      <div ref={element} className="pack__drawing">
        {points.length > 0 && width > 0 && (
          // the table below has the same for those who do not see it
          <svg width={width} height={HEIGHT} aria-hidden>
            {LINES.map((grade) => (
              <g key={grade} className="pack__axis">
                <line x1={MARGIN.left} x2={width - MARGIN.right} y1={heightOf(grade, HEIGHT)} y2={heightOf(grade, HEIGHT)} />
                <text x={MARGIN.left - 8} y={heightOf(grade, HEIGHT) + 4} textAnchor="end">
                  {grade}
                </text>
              </g>
            ))}
            {lines.map((line) => (
              <polyline key={line} className="pack__trace" points={line} />
            ))}
            {points.map(({ card, x, y }) => (
              // biome-ignore lint/a11y/noStaticElementInteractions: a shortcut for the pointer: the cards below are reached by keys
              <g
                key={card.key}
                className={card.grade?.isOld ? 'pack__point pack__point--old' : 'pack__point'}
                onClick={() => onGo(card)}
              >
                <title>{`${card.number} ${card.entry?.name ?? card.id}: ${card.grade?.value?.toFixed(1)} ${card.grade?.word}`}</title>
                <circle cx={x} cy={y} r={10} className="pack__target" />
                <circle cx={x} cy={y} r={4} />
                {card.jump !== null && (
                  <>
                    <path d={`M${x - 5},${y - 8} h10 l-5,-7 z`} className="pack__jump" />
                    <text x={x} y={HEIGHT - 4} textAnchor="middle" className="pack__jump">
                      +{card.jump.toFixed(1)}
                    </text>
                  </>
                )}
              </g>
            ))}
          </svg>
        )}
      </div>
      {points.length > 0 && (
        <details className="pack__table">
          <summary>The curve as a table</summary>
          <table>
            <thead>
              <tr>
                <th scope="col">place</th>
                <th scope="col">level</th>
                <th scope="col">grade</th>
                <th scope="col">jump</th>
              </tr>
            </thead>
            <tbody>
              {cards
                .filter(({ isListed }) => isListed)
                .map((card) => (
                  <tr key={card.key}>
                    <td className="numbers">{card.number}</td>
                    <td>{card.entry?.name ?? card.id}</td>
                    <td className="numbers">{gradeInWords(card)}</td>
                    <td className="numbers">{card.jump === null ? '' : `+${card.jump.toFixed(1)}`}</td>
                  </tr>
                ))}
            </tbody>
          </table>
        </details>
      )}
    </figure>
  );
}

function jumpsInWords(places: readonly number[]): string {
  if (places.length === 0) return 'No jump.';
  return `${places.length === 1 ? 'A jump' : 'Jumps'} at ${places.join(', ')}: ${JUMP} and more above all before.`;
}

function gradeInWords({ grade }: Card): string {
  if (grade === null) return 'not measured';
  if (grade.value === null) return grade.word;
  return `${grade.value.toFixed(1)} ${grade.word}${grade.isOld ? ', before the last change' : ''}`;
}

/** A level on the curve. */
interface CurvePoint {
  readonly card: Card;
  /** px from the left and from the top */
  readonly x: number;
  readonly y: number;
}

/** The curve of difficulty as a drawing. */
interface Curve {
  readonly points: readonly CurvePoint[];
  /** Lines through levels that follow one another, as points of an SVG polyline. */
  readonly lines: readonly string[];
}

/** px around the drawing: on the left there is room for the grades */
const MARGIN = { left: 26, right: 10, top: 16, bottom: 18 } as const;

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
