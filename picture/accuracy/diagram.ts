import { drawText, type TextStyle, textWidth } from '../text.ts';
import { type Ground, type Ink, inked, inkStyle } from '../theme.ts';
import { escapeXml, num, polyline } from '../xml.ts';
import { decades, drawMark, type LineKind, logAxis, placeLabels, powerOfTen } from './axis.ts';

/** One measured setting in a diagram. */
export interface DiagramPoint {
  /** Error, px; for a pack the median over its runs. */
  readonly error: number;
  /** The error that nine of ten runs stay below, px; null for a single run. */
  readonly worseError: number | null;
  /** Cost, microseconds per simulated second. */
  readonly cost: number;
  /** The number of runs that end differently from the reference. */
  readonly failures: number;
  /** The name of a named setting, which gets a ring and this label; else null. */
  readonly label: string | null;
  /** The setting, as a small text beside the point; null for none. */
  readonly note: string | null;
}

/** The measured settings of one method. */
export interface DiagramLine {
  readonly name: string;
  readonly kind: LineKind;
  /** Whether it is dashed, with small marks. */
  readonly faint: boolean;
  readonly points: readonly DiagramPoint[];
}

/** What a work-precision diagram shows. */
export interface Diagram {
  readonly title: string;
  /** At most two lines. */
  readonly subtitle: readonly string[];
  /** The number of runs behind each point. */
  readonly runs: number;
  /** The error of the reference, px. */
  readonly floor: number;
  readonly lines: readonly DiagramLine[];
}

const WIDTH = 960;
const HEIGHT = 580;
const PLOT = { left: 84, top: 114, right: 664, bottom: 506 };
const FAILED = { left: 684, right: 772 };
const LEGEND = { left: 796, top: 126, step: 25 };

/** Draws a work-precision diagram as a standalone SVG document. The same input gives the same text. */
export function drawDiagram(diagram: Diagram, ground: Ground = 'auto'): string {
  const { title, subtitle, runs, floor, lines } = diagram;
  const good = (point: DiagramPoint): boolean => point.failures < runs;
  const points = lines.flatMap((line) => line.points);
  const shown = points.filter(good);
  const x = logAxis(
    [...shown.flatMap((p) => [p.error, p.label === null ? p.error : (p.worseError ?? p.error)]), floor],
    PLOT.left,
    PLOT.right,
  );
  const y = logAxis(
    points.map((point) => point.cost),
    PLOT.bottom,
    PLOT.top,
  );
  const mostFailures = Math.max(0, ...points.map((point) => point.failures));

  const ink = (name: Ink, drawings: string): string => inked(ground, name, drawings);
  const write = (text: string, tx: number, ty: number, style: Partial<TextStyle> = {}): string =>
    drawText(text, tx, ty, { size: 8, color: 'currentColor', ...style });
  const line = (x1: number, y1: number, x2: number, y2: number, more = ''): string =>
    `<path d="M${num(x1)} ${num(y1)}L${num(x2)} ${num(y2)}" stroke="currentColor" fill="none" ${more}/>`;

  const parts: string[] = [];
  parts.push(ink('panel', `<rect width="${WIDTH}" height="${HEIGHT}" rx="10" fill="currentColor"/>`));
  parts.push(ink('text', write(title, 24, 36, { size: 13, bold: true, maxWidth: WIDTH - 48 })));
  parts.push(ink('muted', subtitle.map((text, i) => write(text, 24, 58 + 16 * i, { maxWidth: 640 })).join('')));
  parts.push(drawGround());
  parts.push(mostFailures > 0 ? drawFailures() : '');
  for (const faint of [true, false]) for (const drawn of lines) if (drawn.faint === faint) parts.push(drawLine(drawn));
  parts.push(drawLabels(), drawLegend());

  return (
    `<svg xmlns="http://www.w3.org/2000/svg" width="${WIDTH}" height="${HEIGHT}" viewBox="0 0 ${WIDTH} ${HEIGHT}" role="img">` +
    `<title>${escapeXml(title)}</title><desc>${escapeXml(subtitle.join(' '))}</desc>${inkStyle(ground)}${parts.join('')}</svg>\n`
  );

  function drawGround(): string {
    const rules: string[] = [];
    const texts: string[] = [];
    for (const power of decades(x, 8)) {
      const at = x.at(10 ** power);
      rules.push(line(at, PLOT.top, at, PLOT.bottom));
      texts.push(write(powerOfTen(power), at, PLOT.bottom + 19, { anchor: 'middle' }));
    }
    for (const power of decades(y, 6)) {
      const at = y.at(10 ** power);
      rules.push(line(PLOT.left, at, PLOT.right, at));
      texts.push(write(powerOfTen(power), PLOT.left - 9, at + 4, { anchor: 'end' }));
    }
    texts.push(write('error, px', (PLOT.left + PLOT.right) / 2, PLOT.bottom + 44, { anchor: 'middle', size: 9 }));
    const middle = (PLOT.top + PLOT.bottom) / 2;
    texts.push(
      `<g transform="rotate(-90 26 ${middle})">${write('microseconds per simulated second', 26, middle, { anchor: 'middle', size: 9 })}</g>`,
    );
    const [ax, ay] = [PLOT.left + 16, PLOT.bottom - 16];
    texts.push(write('faster, more exact', ax + 18, ay - 8, { size: 7.5 }));
    texts.push(line(ax + 14, ay - 14, ax, ay, 'stroke-width="1.4"'), line(ax, ay, ax + 7, ay, 'stroke-width="1.4"'));
    texts.push(line(ax, ay, ax, ay - 7, 'stroke-width="1.4"'));
    for (let power = y.low; power < y.high; power++) {
      for (let k = 2; k <= 9; k++) rules.push(line(PLOT.left, y.at(k * 10 ** power), PLOT.left + 5, y.at(k * 10 ** power)));
    }
    const rounding = x.at(floor) - PLOT.left;
    const shade =
      floor > 0 && rounding > 0
        ? `<rect x="${PLOT.left}" y="${PLOT.top}" width="${num(rounding)}" height="${PLOT.bottom - PLOT.top}" fill="currentColor"/>`
        : '';
    const marks = [
      [0.01, '0.01 px'],
      [1, 'one pixel'],
    ] as const;
    for (const [value, text] of marks) {
      const at = x.at(value);
      if (at <= PLOT.left + 40 || at >= PLOT.right) continue;
      rules.push(line(at, PLOT.top - 6, at, PLOT.bottom, 'stroke-width="2"'));
      texts.push(write(text, at, PLOT.top - 12, { anchor: 'middle', size: 7.5 }));
    }
    if (shade !== '') texts.push(write('rounding', PLOT.left + 2, PLOT.top - 12, { size: 7.5 }));
    return ink('shade', shade) + ink('rule', rules.join('')) + ink('muted', texts.join(''));
  }

  function failedX(lineIndex: number, failures: number): number {
    if (runs === 1) return FAILED.left + ((lineIndex + 0.5) / lines.length) * (FAILED.right - FAILED.left);
    return FAILED.left + 8 + (failures / mostFailures) * (FAILED.right - FAILED.left - 16);
  }

  function drawFailures(): string {
    const { left, right } = FAILED;
    const middle = (left + right) / 2;
    const texts = [
      write('another', middle, PLOT.top - 26, { anchor: 'middle', size: 7.5 }),
      write('outcome', middle, PLOT.top - 12, { anchor: 'middle', size: 7.5 }),
    ];
    if (runs > 1) {
      for (const count of [0, mostFailures]) {
        texts.push(write(String(count), failedX(0, count), PLOT.bottom + 19, { anchor: 'middle' }));
      }
      texts.push(write(`of ${runs} runs`, middle, PLOT.bottom + 44, { anchor: 'middle', size: 9 }));
    }
    const box = `<rect x="${left}" y="${PLOT.top}" width="${right - left}" height="${PLOT.bottom - PLOT.top}" fill="currentColor"/>`;
    return ink('shade', box) + ink('muted', texts.join(''));
  }

  function drawLine({ kind, faint, points: own }: DiagramLine): string {
    const index = lines.findIndex((other) => other.points === own);
    const places = own.filter(good).map((p) => [x.at(p.error), y.at(p.cost)] as const);
    const width = faint ? 'stroke-width="1.1" stroke-dasharray="3 3" opacity="0.75"' : 'stroke-width="1.8"';
    const r = faint ? 3.2 : 5.2;
    let drawn = places.length > 1 ? `<path d="${polyline(places)}" fill="none" stroke="currentColor" ${width}/>` : '';
    for (const point of own) {
      const at = y.at(point.cost);
      if (good(point)) drawn += drawMark(kind, x.at(point.error), at, r, point.failures > 0);
      if (point.failures > 0) drawn += drawMark(kind, failedX(index, point.failures), at, r, true);
      if (point.label === null || !good(point)) continue;
      if (!faint && kind !== 'peer') {
        drawn += `<circle cx="${num(x.at(point.error))}" cy="${num(at)}" r="9" fill="none" stroke="currentColor" stroke-width="1.4"/>`;
      }
      if (point.worseError === null || kind === 'peer') continue;
      const to = x.at(point.worseError);
      drawn += line(x.at(point.error), at, to, at, 'stroke-width="1.2"') + line(to, at - 4, to, at + 4, 'stroke-width="1.2"');
    }
    return ink(kind, drawn);
  }

  function drawLabels(): string {
    const wanted = lines.flatMap(({ kind, points: own }, index) =>
      own.flatMap((p) => {
        const at = { kind, x: good(p) ? x.at(p.error) : failedX(index, p.failures), y: y.at(p.cost) };
        if (p.label !== null) return [{ ...at, text: p.label, style: { size: 8.5, bold: kind !== 'peer' } }];
        return p.note === null || !good(p) ? [] : [{ ...at, text: p.note, style: { size: 7 } }];
      }),
    );
    // Names are placed first and get the better places.
    wanted.sort((a, b) => b.style.size - a.style.size);
    const marks = lines.flatMap((drawn, index) => alongLine(drawn, index));
    const within = { left: PLOT.left, right: FAILED.right, top: PLOT.top, bottom: PLOT.bottom };
    const placed = placeLabels(
      wanted.map((label) => ({ ...label, size: label.style.size })),
      marks,
      within,
    );
    return placed
      .map(({ x: lx, y: ly, leader }, i) => {
        const { kind, text, style, x: px, y: py } = wanted[i];
        const near = Math.max(lx, Math.min(px, lx + textWidth(text, style.size)));
        const lead = leader ? line(near, py < ly ? ly - style.size - 3 : ly + 4, px, py, 'stroke-width="0.8"') : '';
        return ink(kind, lead) + ink(style.size < 8 ? 'muted' : 'text', write(text, lx, ly, style));
      })
      .join('');
  }

  /** Marks, and points along the segments between them, that a label should not cover. */
  function alongLine({ points: own }: DiagramLine, index: number): (readonly [number, number])[] {
    const places = own.filter(good).map((p) => [x.at(p.error), y.at(p.cost)] as const);
    const between = places.slice(1).flatMap(([toX, toY], i) => {
      const [fromX, fromY] = places[i];
      const count = Math.floor(Math.hypot(toX - fromX, toY - fromY) / 8);
      return Array.from({ length: count }, (_, k) => {
        const part = (k + 1) / (count + 1);
        return [fromX + part * (toX - fromX), fromY + part * (toY - fromY)] as const;
      });
    });
    const failed = own.filter((p) => p.failures > 0).map((p) => [failedX(index, p.failures), y.at(p.cost)] as const);
    return [...places, ...between, ...failed];
  }

  function drawLegend(): string {
    let at = LEGEND.top;
    let drawn = '';
    let peersNamed = false;
    for (const { name, kind, faint } of lines) {
      if (kind === 'peer' && peersNamed) continue;
      peersNamed ||= kind === 'peer';
      const dash = faint ? 'stroke-width="1.1" stroke-dasharray="3 3"' : 'stroke-width="1.8"';
      drawn += ink(
        kind,
        line(LEGEND.left, at - 4, LEGEND.left + 26, at - 4, dash) +
          drawMark(kind, LEGEND.left + 13, at - 4, faint ? 3.2 : 5.2, false),
      );
      drawn += ink('text', write(kind === 'peer' ? 'other engines' : name, LEGEND.left + 35, at));
      at += LEGEND.step;
    }
    const notes = ['hollow: a run has', 'another outcome'];
    if (runs > 1) notes.push('', 'marks: median run', 'whiskers: to the', '90th percentile');
    drawn += ink('muted', notes.map((note, i) => write(note, LEGEND.left, at + 14 + 16 * i, { size: 7.5 })).join(''));
    return drawn;
  }
}
