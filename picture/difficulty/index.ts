import { drawText, type TextStyle, textWidth } from '../text.ts';
import { type Ground, type Ink, inked, inkStyle } from '../theme.ts';
import { escapeXml, num, polyline } from '../xml.ts';

export type { Ground } from '../theme.ts';

/** What a picture of difficulty shows. */
export interface DifficultyPicture {
  readonly title: string;
  /** At most two lines. */
  readonly subtitle: readonly string[];
  readonly curves: readonly SuccessCurve[];
  /** The slack of each press and release of a single level; empty otherwise. */
  readonly edges: readonly Edge[];
  /** The largest shift of an edge that was tried, ticks. */
  readonly limit: number;
}

const WIDTH = 960;
const TOP = 122;
const BOTTOM = 60;
const PLOT_HEIGHT = 380;
const LEAST_ROW = 15;
const ROW = 26;

/**
 * Draws success under timing noise and the slack of each press and release, as a standalone SVG document. The same input gives
 * the same text.
 */
export function drawDifficulty(picture: DifficultyPicture, ground: Ground = 'auto'): string {
  const { title, subtitle, curves, edges, limit } = picture;
  const row = Math.max(LEAST_ROW, Math.min(ROW, PLOT_HEIGHT / Math.max(1, edges.length)));
  const plotHeight = Math.max(PLOT_HEIGHT, edges.length * row);
  const height = TOP + plotHeight + BOTTOM;
  const hasWindows = edges.length > 0;
  const parts = [
    inked(ground, 'panel', `<rect width="${WIDTH}" height="${height}" rx="10" fill="currentColor"/>`),
    inked(ground, 'text', drawText(title, 24, 36, { size: 13, color: 'currentColor', bold: true, maxWidth: WIDTH - 48 })),
    inked(
      ground,
      'muted',
      subtitle
        .map((text, i) => drawText(text, 24, 58 + 16 * i, { size: 8, color: 'currentColor', maxWidth: WIDTH - 48 }))
        .join(''),
    ),
    drawCurves(curves, { left: 76, right: hasWindows ? 520 : 720, top: TOP, bottom: TOP + PLOT_HEIGHT }, ground),
    hasWindows ? drawWindows(edges, limit, { left: 640, right: 920, top: TOP, row }, ground) : '',
  ];
  return (
    `<svg xmlns="http://www.w3.org/2000/svg" width="${WIDTH}" height="${height}" viewBox="0 0 ${WIDTH} ${height}" role="img">` +
    `<title>${escapeXml(title)}</title><desc>${escapeXml(subtitle.join(' '))}</desc>${inkStyle(ground)}${parts.join('')}</svg>\n`
  );
}

/** The slack of a press or release: how far it can move alone. */
interface Edge {
  /** Its name, such as `press 1`. */
  readonly label: string;
  /** Slack, ticks; at most `limit` each. */
  readonly earlier: number;
  readonly later: number;
}

const MS = 1000 / 60;

/** Draws the slack of each press and release as a bar. The smallest window is emphasized. */
function drawWindows(
  edges: readonly Edge[],
  limit: number,
  { left, right, top, row }: { readonly left: number; readonly right: number; readonly top: number; readonly row: number },
  ground: Ground,
): string {
  const middle = (left + right) / 2;
  const widest = Math.max(4, ...edges.flatMap(({ earlier, later }) => [earlier, later]));
  const scale = (right - left) / 2 / widest;
  const bottom = top + row * edges.length;
  const smallest = Math.min(...edges.map(({ earlier, later }) => earlier + later));
  const write = (text: string, x: number, y: number, style: Partial<TextStyle> = {}): string =>
    drawText(text, x, y, { size: 7.5, color: 'currentColor', ...style });

  let axis = `M${num(middle)} ${top - 4}V${num(bottom + 4)}`;
  let texts = write('how far each can move alone', left - 66, top - 26, { size: 9 });
  texts += write('earlier', left, top - 9) + write('later', right, top - 9, { anchor: 'end' });
  const step = [5, 10, 15, 30].find((s) => widest / s <= 2.5) ?? 30;
  for (let ticks = 0; ticks <= widest; ticks += step) {
    for (const side of ticks === 0 ? [1] : [-1, 1]) {
      const x = middle + side * ticks * scale;
      if (ticks > 0) axis += `M${num(x)} ${top - 4}V${num(bottom + 4)}`;
      texts += write(ticks === 0 ? '0' : String(Math.round(ticks * MS)), x, bottom + 18, { anchor: 'middle' });
    }
  }
  texts += write('ms', right + 14, bottom + 18);
  const tightest = `smallest window: ${Math.round(smallest * MS)} ms`;
  const parts = [inked(ground, 'rule', `<path d="${axis}" stroke="currentColor" fill="none"/>`)];
  for (const [i, { label, earlier, later }] of edges.entries()) {
    const y = top + row * i + row / 2;
    const isSmallest = earlier + later === smallest;
    const thick = Math.min(12, 0.55 * row);
    const from = middle - earlier * scale;
    const width = Math.max(1.5, (earlier + later) * scale);
    const bar = `<rect x="${num(from)}" y="${num(y - thick / 2)}" width="${num(width)}" height="${num(thick)}" rx="2" fill="currentColor"${isSmallest ? '' : ' fill-opacity=".75"'}/>`;
    // A bar that ends at the limit has an arrow, because the slack may be larger.
    const arrows =
      (earlier >= limit ? `<path d="M${num(from - 2)} ${num(y - 5)}l-6 5l6 5Z" fill="currentColor"/>` : '') +
      (later >= limit ? `<path d="M${num(from + width + 2)} ${num(y - 5)}l6 5l-6 5Z" fill="currentColor"/>` : '');
    parts.push(inked(ground, isSmallest ? 'arcade' : 'verlet', bar + arrows));
    parts.push(inked(ground, 'text', write(label, left - 14, y + 3, { anchor: 'end', bold: isSmallest })));
  }
  parts.push(
    inked(ground, 'muted', texts),
    inked(ground, 'arcade', write(tightest, left - 66, bottom + 44, { size: 8.5, bold: true })),
  );
  return parts.join('');
}

/** Success under timing noise, 0 to 1, with its 95 % confidence interval. */
interface SuccessPoint {
  /** Standard deviation of each edge's time, ms. */
  readonly sigma: number;
  readonly p: number;
  readonly low: number;
  readonly high: number;
}

/** The success of one level's run as a function of timing noise. */
interface SuccessCurve {
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
function drawCurves(curves: readonly SuccessCurve[], plot: Plot, ground: Ground): string {
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
