import type { Accuracy } from '../../engine/index.ts';
import { type Measured, RATES, TOLERANCES, type WorkPrecision } from '../../engine/work-precision/index.ts';
import type { Diagram, DiagramLine, DiagramPoint } from './diagram.ts';
import type { LineKind } from './mark.ts';

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
  return { title, subtitle, runs: 1, floor: reference.floor, lines: linesOf(methods, point) };
}
