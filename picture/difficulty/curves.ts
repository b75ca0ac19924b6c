import { type Ground, type Ink, inked } from '../ink.ts';
import { drawText, type TextStyle, textWidth } from '../text.ts';
import { num, polyline } from '../xml.ts';

/** Success under timing noise, 0 to 1, with its 95 % confidence interval. */
export interface SuccessPoint {
  /** Standard deviation of each edge's time, ms. */
  readonly sigma: number;
  readonly p: number;
  readonly low: number;
  readonly high: number;
}

/** The success of one level's run as a function of timing noise. */
export interface SuccessCurve {
  readonly name: string;
  /** The points by ascending sigma. */
  readonly points: readonly SuccessPoint[];
  /** The noise at which success is 0.5, ms; null when it is beyond what was tried. */
  readonly half: number | null;
}

interface Plot {
  readonly left: number;
  readonly right: number;
  readonly top: number;
  readonly bottom: number;
}

const INKS: readonly Ink[] = ['verlet', 'euler', 'taylor', 'rk4', 'arcade', 'peer'];
const DASHES = ['', '7 3', '2 3', '9 3 2 3', '4 2', '1 2'] as const;

/** The colour and dashes of a curve. All of the first 36 combinations differ, and neighbours differ in both. */
const styleOf = (i: number): readonly [ink: Ink, dash: string] => [
  INKS[i % INKS.length],
  DASHES[(i + 2 * Math.floor(i / INKS.length)) % DASHES.length],
];

/** The most curves for which bands of uncertainty are drawn. */
const MOST_BANDS = 2;

const AXIS_STEPS = [10, 20, 25, 50, 100] as const;

const write = (text: string, x: number, y: number, style: Partial<TextStyle> = {}): string =>
  drawText(text, x, y, { size: 8, color: 'currentColor', ...style });

/** Draws success as a function of noise, with its confidence interval, and where it falls to one half. */
export function drawCurves(curves: readonly SuccessCurve[], plot: Plot, ground: Ground): string {
  const { left, right, top, bottom } = plot;
  const most = Math.max(50, ...curves.flatMap(({ points }) => points.map(({ sigma }) => sigma)));
  const x = (sigma: number): number => left + (sigma / most) * (right - left);
  const y = (p: number): number => bottom - p * (bottom - top);

  const step = AXIS_STEPS.find((s) => most / s <= 8) ?? 200;
  let rules = '';
  let texts = '';
  for (let sigma = 0; sigma <= most; sigma += step) {
    rules += `M${num(x(sigma))} ${top}V${bottom}`;
    texts += write(String(sigma), x(sigma), bottom + 19, { anchor: 'middle' });
  }
  for (const p of [0, 0.25, 0.5, 0.75, 1]) {
    rules += `M${left} ${num(y(p))}H${right}`;
    texts += write(`${100 * p} %`, left - 9, y(p) + 3.5, { anchor: 'end' });
  }
  texts += write('timing noise of each press and release, ms', (left + right) / 2, bottom + 42, { anchor: 'middle', size: 9 });
  texts += write('attempts that succeed', left, top - 12, { size: 9 });
  const parts = [
    inked(ground, 'rule', `<path d="${rules}" stroke="currentColor" fill="none"/>`),
    inked(
      ground,
      'muted',
      `${texts}<path d="M${left} ${num(y(0.5))}H${right}" stroke="currentColor" stroke-dasharray="1 5" stroke-linecap="round"/>`,
    ),
  ];
  for (const [i, { points, half }] of curves.entries()) {
    const [ink, dash] = styleOf(i);
    const band = curves.length > MOST_BANDS ? '' : bandOf(points.map(({ sigma, low, high }) => [x(sigma), y(low), y(high)]));
    const line = polyline(points.map(({ sigma, p }) => [x(sigma), y(p)]));
    const dots =
      curves.length > MOST_BANDS
        ? ''
        : points.map(({ sigma, p }) => `<circle cx="${num(x(sigma))}" cy="${num(y(p))}" r="2.6" fill="currentColor"/>`).join('');
    const dashed = dash === '' ? '' : ` stroke-dasharray="${dash}"`;
    const cross =
      half === null
        ? ''
        : `<path d="M${num(x(half))} ${num(y(0.5) - 7)}l6 7l-6 7l-6 -7Z" fill="currentColor" stroke="currentColor"/>`;
    parts.push(
      inked(
        ground,
        ink,
        `${band}<path d="${line}" fill="none" stroke="currentColor" stroke-width="1.9"${dashed}/>${dots}${cross}`,
      ),
    );
  }
  parts.push(curves.length === 1 ? nameHalf(curves[0]) : drawLegend());
  return parts.join('');

  function nameHalf({ half }: SuccessCurve): string {
    if (half === null) return '';
    const text = `half at ${half.toFixed(0)} ms`;
    const width = textWidth(text, 8.5);
    const fits = x(half) + 14 + width < right;
    return inked(
      ground,
      'text',
      write(text, fits ? x(half) + 13 : x(half) - 13 - width, fits ? y(0.5) - 9 : y(0.5) + 17, { size: 8.5, bold: true }),
    );
  }

  function drawLegend(): string {
    return curves
      .map(({ name, half }, i) => {
        const [ink, dash] = styleOf(i);
        const at = top + 10 + 26 * i;
        const dashed = dash === '' ? '' : ` stroke-dasharray="${dash}"`;
        const sample = `<path d="M${right + 24} ${at - 3}h26" stroke="currentColor" stroke-width="1.9" fill="none"${dashed}/>`;
        const what = half === null ? `half above ${most} ms` : `half at ${half.toFixed(0)} ms`;
        return (
          inked(ground, ink, sample) +
          inked(ground, 'text', write(name, right + 58, at, { maxWidth: 180 })) +
          inked(ground, 'muted', write(what, right + 58, at + 12, { size: 6.5 }))
        );
      })
      .join('');
  }
}

function bandOf(points: readonly (readonly [x: number, low: number, high: number])[]): string {
  const above = points.map(([x, , high]) => [x, high] as const);
  const below = points.map(([x, low]) => [x, low] as const).reverse();
  return `<path d="${polyline([...above, ...below], true)}" fill="currentColor" fill-opacity=".16"/>`;
}
