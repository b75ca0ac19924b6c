import type { Accuracy } from '../../engine/index.ts';
import { type Measured, RATES, TOLERANCES, type WorkPrecision } from '../../engine/work-precision/index.ts';
import { drawText, type TextStyle } from '../text.ts';
import { type Ground, type Ink, inked, inkStyle } from '../theme.ts';
import { escapeXml, num, polyline } from '../xml.ts';
import type { LineKind } from './axis.ts';
import type { Diagram, DiagramLine, DiagramPoint } from './diagram.ts';

export type { Ground } from '../theme.ts';
export { type Diagram, type DiagramPoint, drawDiagram } from './diagram.ts';

/** The name of a line in a diagram: `rk4`, `rk4, frame tests`. */
const lineName = ({ integrator, contact }: Accuracy): string =>
  integrator === 'arcade' ? 'arcade' : contact === 'frame' ? `${integrator}, frame tests` : integrator;

/** Groups measured settings into lines, one for each integrator and contact test, in order of appearance. */
export function linesOf<T extends { readonly accuracy: Accuracy }>(
  measured: readonly T[],
  point: (measured: T) => DiagramPoint,
): DiagramLine[] {
  const lines = new Map<string, { kind: LineKind; faint: boolean; points: DiagramPoint[] }>();
  for (const one of measured) {
    const name = lineName(one.accuracy);
    const { integrator, contact } = one.accuracy;
    const line = lines.get(name) ?? { kind: integrator, faint: contact === 'frame' && integrator !== 'arcade', points: [] };
    line.points.push(point(one));
    lines.set(name, line);
  }
  return [...lines].map(([name, line]) => ({ name, ...line }));
}

/** The text beside the point of a setting; only the first and the last point of a line have one. */
export function noteOf({ rate, tolerance }: Accuracy): string | null {
  const ends: readonly (number | null)[] = [RATES[0], RATES[RATES.length - 1], TOLERANCES[0]];
  if (rate !== null) return ends.includes(rate) ? `${rate} Hz` : null;
  return ends.includes(tolerance) ? `${tolerance?.toExponential()} px` : null;
}

/**
 * Creates the diagram of one run of a level.
 * @param named the settings that are labelled
 */
export function levelDiagram(
  title: string,
  subtitle: readonly string[],
  { reference, methods }: WorkPrecision,
  named: readonly string[],
): Diagram {
  const point = ({ accuracy, error, cost, sameVerdict }: Measured): DiagramPoint => ({
    error,
    worseError: null,
    cost: cost.minimum,
    failures: sameVerdict ? 0 : 1,
    label: named.includes(accuracy.name) ? accuracy.name : null,
    note: accuracy.contact === 'swept' ? noteOf(accuracy) : null,
  });
  return { title, subtitle, runs: 1, floor: reference.knownTo ?? 0, lines: linesOf(methods, point) };
}

/** The share of contacts that a test once per frame misses, by speed, for circles of one radius. */
export interface TunnellingCurve {
  /** Radius of the circles, px. */
  readonly radius: number;
  /** Pairs of speed, px/s, and share of missed contacts, 0 to 1. */
  readonly points: readonly (readonly [speed: number, missed: number])[];
}

/** What a diagram of missed contacts shows. */
interface Tunnelling {
  readonly title: string;
  readonly subtitle: string;
  readonly curves: readonly TunnellingCurve[];
  /** A text beside the zero line. */
  readonly sweptNote: string;
}

const WIDTH = 640;
const HEIGHT = 380;
const PLOT = { left: 70, top: 84, right: 560, bottom: 318 };
const LABEL_STEP = 15;

/**
 * Draws the share of contacts that a test once per frame misses, as a standalone SVG document. The same input gives the same
 * text.
 */
export function drawTunnelling({ title, subtitle, curves, sweptNote }: Tunnelling, ground: Ground = 'auto'): string {
  const all = curves.flatMap((curve) => curve.points);
  const fastest = Math.max(...all.map(([speed]) => speed));
  const most = Math.max(...all.map(([, missed]) => missed), 0.001);
  const step = [0.001, 0.002, 0.005, 0.01, 0.02, 0.05, 0.1, 0.2].find((s) => most / s <= 6) ?? 0.5;
  const top = step * Math.ceil(most / step);
  const x = (speed: number): number => PLOT.left + (speed / fastest) * (PLOT.right - PLOT.left);
  const y = (share: number): number => PLOT.bottom - (share / top) * (PLOT.bottom - PLOT.top);
  const ink = (name: Ink, drawings: string): string => inked(ground, name, drawings);
  const write = (text: string, tx: number, ty: number, style: Partial<TextStyle> = {}): string =>
    drawText(text, tx, ty, { size: 8, color: 'currentColor', ...style });

  const rules: string[] = [];
  const texts: string[] = [];
  for (let i = 0; i * step <= top + 1e-9; i++) {
    rules.push(`M${PLOT.left} ${num(y(i * step))}H${PLOT.right}`);
    texts.push(write(`${Number((100 * i * step).toPrecision(3))}%`, PLOT.left - 8, y(i * step) + 4, { anchor: 'end' }));
  }
  for (let speed = 0; speed <= fastest; speed += 200) {
    rules.push(`M${num(x(speed))} ${PLOT.top}V${PLOT.bottom}`);
    texts.push(write(String(speed), x(speed), PLOT.bottom + 18, { anchor: 'middle' }));
  }
  texts.push(write('speed, px/s', (PLOT.left + PLOT.right) / 2, PLOT.bottom + 42, { anchor: 'middle', size: 9 }));

  // Labels stand at the ends of the lines, from top to bottom, and are moved apart where they would touch.
  const ends = curves.map(({ radius, points }, i) => ({ i, radius, y: y(points[points.length - 1][1]) }));
  ends.sort((a, b) => a.y - b.y);
  const labels: string[] = [];
  let below = Number.NEGATIVE_INFINITY;
  for (const { radius, y: at } of ends) {
    below = Math.max(below + LABEL_STEP, at + 4);
    labels.push(write(`r ${radius}`, PLOT.right + 10, below));
  }
  const lines = curves.map(({ points }, i) => {
    const places = points.map(([speed, missed]) => [x(speed), y(missed)] as const);
    const opacity = num(1 - (0.7 * i) / Math.max(1, curves.length - 1));
    return `<path d="${polyline(places)}" fill="none" stroke="currentColor" stroke-width="1.8" opacity="${opacity}"/>`;
  });
  const zero = `<path d="M${PLOT.left} ${PLOT.bottom}H${PLOT.right}" stroke="currentColor" stroke-width="2.4" fill="none"/>`;

  return (
    `<svg xmlns="http://www.w3.org/2000/svg" width="${WIDTH}" height="${HEIGHT}" viewBox="0 0 ${WIDTH} ${HEIGHT}" role="img">` +
    `<title>${escapeXml(title)}</title><desc>${escapeXml(`${subtitle} ${sweptNote}`)}</desc>${inkStyle(ground)}` +
    ink('panel', `<rect width="${WIDTH}" height="${HEIGHT}" rx="10" fill="currentColor"/>`) +
    ink('text', write(title, 24, 34, { size: 12, bold: true }) + labels.join('')) +
    ink('muted', write(subtitle, 24, 56, { size: 7.5, maxWidth: WIDTH - 48 }) + texts.join('')) +
    ink('rule', `<path d="${rules.join('')}" stroke="currentColor" fill="none"/>`) +
    ink('euler', lines.join('')) +
    ink('taylor', zero + write(sweptNote, PLOT.left, PLOT.bottom + 42, { size: 7.5 })) +
    '</svg>\n'
  );
}
