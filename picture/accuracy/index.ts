import { ACCURACIES, type Accuracy } from '../../engine/index.ts';
import { type Compared, GOOD_ENOUGH, METHODS, quantile, RATES, TOLERANCES } from '../../engine/work-precision/index.ts';
import { drawText, type TextStyle } from '../text.ts';
import { type Ground, type Ink, inked, inkStyle } from '../theme.ts';
import { escapeXml, num, polyline } from '../xml.ts';
import type { LineKind } from './axis.ts';
import type { Best, Diagram, DiagramLine, DiagramPoint } from './diagram.ts';

export type { Ground } from '../theme.ts';
export { type Diagram, type DiagramPoint, type DrawnDiagram, drawDiagram, layOutDiagram } from './diagram.ts';

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

/** How a setting plays a run. */
interface RunAtSetting {
  readonly accuracy: Accuracy;
  /** The largest distance to the reference, px. */
  readonly error: number;
  /** microseconds per simulated second */
  readonly cost: number;
  /** When the run ends, s. */
  readonly time: number;
  /** Whether its outcome is that of the reference. */
  readonly sameVerdict: boolean;
  /** How it ends, in words. */
  readonly end: string;
}

/** A run at all settings. */
export interface RunAtSettings {
  readonly name: string | null;
  /** How exactly its reference is known, px; null: no second one confirms it. */
  readonly knownTo: number | null;
  readonly settings: readonly RunAtSetting[];
}

interface DiagramOfLevel extends Pick<Diagram, 'title' | 'subtitle' | 'used'> {
  /** At least one. */
  readonly runs: readonly RunAtSettings[];
  /** The settings that are labelled. */
  readonly named: readonly string[];
  /** Whether each run has a point of its own; else a point has all runs. */
  readonly each?: boolean;
}

/** Creates the diagram of the runs of a level. */
export function levelDiagram({ title, subtitle, runs, used, named, each = false }: DiagramOfLevel): Diagram {
  const label = ({ name }: Accuracy) => (name === used || named.includes(name) ? name : null);
  const texts = (accuracy: Accuracy) => ({
    label: label(accuracy),
    note: accuracy.contact === 'swept' ? noteOf(accuracy) : null,
  });
  const floor = Math.max(0, ...runs.map(({ knownTo }) => knownTo ?? 0));
  if (runs.length === 1 || each) {
    const lines = runs.flatMap((run) =>
      linesOf(run.settings, (one) => ({
        ...texts(one.accuracy),
        ...{ error: one.error, worseError: null, cost: one.cost, failures: one.sameVerdict ? 0 : 1, time: one.time },
        words: `${runs.length > 1 ? `${run.name}: ` : ''}${runInWords(one, run.knownTo)}`,
      })),
    );
    const diagram = { title, subtitle, runs: 1, floor, used, lines };
    return runs.length === 1 ? { ...diagram, best: bestOf(lines) } : diagram;
  }
  const known = runs.every(({ knownTo }) => knownTo !== null) ? floor : null;
  // a setting of which not all is known has no point
  const all = runs[0].settings.flatMap(({ accuracy }) => {
    const own = runs.flatMap(({ name, settings }) =>
      settings.filter((one) => one.accuracy === accuracy).map((one) => ({ ...one, name })),
    );
    return own.length === runs.length ? [{ accuracy, own }] : [];
  });
  const lines = linesOf(all, ({ accuracy, own }): DiagramPoint => {
    const errors = own.filter(({ sameVerdict }) => sameVerdict).map(({ error }) => error);
    const time = own.reduce((sum, one) => sum + one.time, 0);
    const others = own.filter(({ sameVerdict }) => !sameVerdict);
    const cost = own.reduce((sum, one) => sum + one.cost * one.time, 0) / time;
    const [median, worse] = errors.length === 0 ? [0, null] : [quantile(errors, 0.5), quantile(errors, 0.9)];
    const off =
      errors.length === 0 ? 'no run ends as the reference' : errorInWords(median, known, ` in the median of ${runs.length} runs`);
    const ends =
      others.length === 0
        ? 'all end as their references'
        : `${others.length} of ${runs.length} end otherwise: ${others.map(({ name, end }) => `${name} ${end}`).join(', ')}`;
    return {
      ...texts(accuracy),
      ...{ error: median, worseError: worse, cost, failures: others.length, time: time / runs.length },
      words: `${settingInWords(accuracy)}: ${off}; ${costInWords(cost, time, 'times all runs')}; ${ends}.`,
    };
  });
  return { title, subtitle, runs: runs.length, floor, used, lines, best: bestOf(lines) };
}

/** What is marked among points: settings with the outcome of the reference. */
function bestOf(lines: readonly DiagramLine[]): Best {
  const good = lines.flatMap(({ kind, points }) =>
    points.filter(({ failures }) => failures === 0).map((point) => ({ kind, point })),
  );
  const worst = ({ error, worseError }: DiagramPoint): number => worseError ?? error;
  const ofFamilies = new Set<DiagramPoint>();
  for (const kind of new Set(good.map((one) => one.kind))) {
    const own = good.filter((one) => one.kind === kind).map(({ point }) => point);
    const exact = own.filter((point) => worst(point) < GOOD_ENOUGH).sort((a, b) => a.cost - b.cost);
    ofFamilies.add(exact[0] ?? own.sort((a, b) => worst(a) - worst(b))[0]);
  }
  const front: DiagramPoint[] = [];
  for (const { point } of [...good].sort((a, b) => a.point.cost - b.point.cost || a.point.error - b.point.error))
    if (front.length === 0 || point.error < front[front.length - 1].error) front.push(point);
  return { ofFamilies, front };
}

// a point in words

/** A length, a time or a cost with two significant digits: 12, 0.034, 5.6e-7. */
export function brief(value: number): string {
  if (value === 0) return '0';
  if (value < 1e-3 || value >= 1e5) return value.toExponential(1);
  return value >= 100 ? value.toFixed(0) : String(Number(value.toPrecision(2)));
}

/** An error, which means no more than how exactly the reference is known; in brackets where that is not known. */
export function errorIn(error: number, knownTo: number | null): string {
  if (knownTo === null) return `(${brief(error)})`;
  return error < knownTo ? `< ${brief(knownTo)}` : brief(error);
}

type OfSetting = { readonly accuracy: Accuracy };

/** What was not measured, and why: a sentence for each reason. */
export function unmeasuredInWords(maxWork: number, unmeasured: Compared['unmeasured']): string[] {
  const over = unmeasured
    .filter(({ why }) => why === 'work')
    .map((one) => `${one.accuracy.name} (up to ${one.time.toFixed(2)} s)`);
  const late = unmeasured.filter(({ why }) => why === 'time');
  return [
    ...(over.length > 0 ? [`Over the work limit of ${maxWork} pieces of motion, so not measured: ${over.join('; ')}.`] : []),
    ...(late.length > 0 ? [`Not measured, as the time for it was used up: ${settingsInGroups(late)}.`] : []),
  ];
}

/** Names settings, with whole groups in short: `every euler with frame tests; verlet 15 Hz, verlet 30 Hz`. */
export function settingsInGroups(
  some: readonly OfSetting[],
  all: readonly OfSetting[] = METHODS.map((accuracy) => ({ accuracy })),
): string {
  const groupOf = ({ accuracy: { integrator, contact } }: OfSetting): string =>
    integrator === 'arcade' ? integrator : `every ${integrator} with ${contact === 'frame' ? 'frame tests' : 'swept contacts'}`;
  const inGroup = (group: string) => {
    const own = some.filter((one) => groupOf(one) === group);
    const isWhole = own.length === all.filter((one) => groupOf(one) === group).length;
    return isWhole ? group : own.map(({ accuracy }) => accuracy.name).join(', ');
  };
  return [...new Set(some.map(groupOf))].map(inGroup).join('; ');
}

const errorInWords = (error: number, knownTo: number | null, of = ''): string =>
  `off by ${errorIn(error, knownTo)} px${of}, ${knownTo === null ? 'from a reference that no second one confirms' : `known to ${brief(knownTo)} px`}`;

/** How many times a second of one core plays so much time. @param cost microseconds per simulated second; @param time s */
export const runsASecond = (cost: number, time: number): string =>
  Math.round(1e6 / (cost * Math.max(time, 1 / 60))).toLocaleString('en-US');

const costInWords = (cost: number, time: number, plays: string): string =>
  `${brief(cost)} µs a second of play, ${brief(cost / 1e4)} % of a frame at 60 Hz, ${runsASecond(cost, time)} ${plays} a second`;

/** `rk4 at 60 Hz, swept contacts (standard)` */
function settingInWords({ name, integrator, rate, tolerance, contact }: Accuracy): string {
  if (integrator === 'arcade') return 'arcade: euler at 60 Hz, contacts once a frame';
  const size = rate === null ? `to ${tolerance?.toExponential()} px` : `at ${rate} Hz`;
  const own = Object.hasOwn(ACCURACIES, name) ? ` (${name})` : '';
  return `${integrator} ${size}, ${contact === 'frame' ? 'contacts once a frame' : 'swept contacts'}${own}`;
}

function runInWords({ accuracy, error, cost, time, sameVerdict, end }: RunAtSetting, knownTo: number | null): string {
  const outcome = sameVerdict ? end : `another outcome: ${end}`;
  return `${settingInWords(accuracy)}: ${errorInWords(error, knownTo)}; ${costInWords(cost, time, 'runs')}; ${outcome}.`;
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
