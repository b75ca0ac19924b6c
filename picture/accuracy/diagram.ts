import { drawText, type TextStyle, textWidth, wrapText } from '../text.ts';
import { type Ground, type Ink, inked, inkStyle } from '../theme.ts';
import { escapeXml, num, polyline } from '../xml.ts';
import {
  CROSS,
  decades,
  drawBest,
  drawMark,
  FRONT,
  type LineKind,
  logAxis,
  narrowLayout,
  placeLabels,
  powerOfTen,
  WIDE,
} from './axis.ts';

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
  /** When a single run ends, s. */
  readonly time: number;
  /** What it is and all its figures, for who points at it. */
  readonly words: string;
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
  /** The label of the setting in use; null: none is. */
  readonly used: string | null;
  /** The best of each family, and the front that nothing cheaper is as exact as; absent: they are not shown. */
  readonly best?: Best;
  readonly lines: readonly DiagramLine[];
}

/** What is marked in a diagram besides the points. */
export interface Best {
  readonly ofFamilies: ReadonlySet<DiagramPoint>;
  /** From the cheapest on. */
  readonly front: readonly DiagramPoint[];
}

/** A mark of a drawn diagram. */
interface DrawnMark {
  readonly point: DiagramPoint;
  /** Its middle, in units of the picture. */
  readonly x: number;
  readonly y: number;
}

/** A diagram as it is drawn. */
export interface DrawnDiagram {
  readonly svg: string;
  /** The legend, where it is a picture of its own. */
  readonly legend: string | null;
  readonly width: number;
  readonly height: number;
  /** One for each point. */
  readonly marks: readonly DrawnMark[];
}

/** From here on, a label stands outside of the rings. */
const RINGED = 18;

/** How far below the smallest error the error of the reference is still shown. */
const FLOOR_SHOWN = 1e-3;

/** Draws a work-precision diagram as a standalone SVG document. The same input gives the same text. */
export const drawDiagram = (diagram: Diagram, ground: Ground = 'auto'): string => layOutDiagram(diagram, ground).svg;

/** Draws a work-precision diagram. @param width of its place, px; absent: it is drawn with title and legend, 960 wide */
export function layOutDiagram(diagram: Diagram, ground: Ground = 'auto', width?: number): DrawnDiagram {
  const { title, subtitle, runs, floor, used, lines, best } = diagram;
  const good = (point: DiagramPoint): boolean => point.failures < runs;
  const points = lines.flatMap((line) => line.points);
  const shown = points.filter(good);
  const mostFailures = Math.max(0, ...points.map((point) => point.failures));
  const layout = width === undefined ? WIDE : narrowLayout(width, mostFailures > 0);
  const { plot: PLOT, failed: FAILED } = layout;
  const errors = shown.flatMap((p) => [p.error, p.label === null ? p.error : (p.worseError ?? p.error)]);
  // a reference that is known far better than anything is exact would leave no room for the points
  const isNear = floor >= FLOOR_SHOWN * Math.min(...errors.filter((error) => error > 0));
  const x = logAxis(isNear ? [...errors, floor] : errors, PLOT.left, PLOT.right);
  const y = logAxis(
    points.map((point) => point.cost),
    PLOT.bottom,
    PLOT.top,
  );
  const ends = points.filter((point) => point.failures > 0).map(({ time }) => time);
  const [earliest, latest] = [Math.min(...ends), Math.max(...ends)];

  const ink = (name: Ink, drawings: string): string => inked(ground, name, drawings);
  const write = (text: string, tx: number, ty: number, style: Partial<TextStyle> = {}): string =>
    drawText(text, tx, ty, { size: 8, color: 'currentColor', ...style });
  const line = (x1: number, y1: number, x2: number, y2: number, more = ''): string =>
    `<path d="M${num(x1)} ${num(y1)}L${num(x2)} ${num(y2)}" stroke="currentColor" fill="none" ${more}/>`;

  const body = [
    drawGround(),
    mostFailures > 0 ? drawFailures() : '',
    drawFront(),
    ...[true, false].flatMap((faint) => lines.filter((drawn) => drawn.faint === faint).map(drawLine)),
    drawUsed(),
    drawLabels(),
  ].join('');
  const marks = lines.flatMap(({ points: own }) => own.map((point): DrawnMark => ({ point, ...placeOf(point) })));
  const picture = { width: layout.width, height: layout.height, marks };
  if (layout.legend === null) {
    const { drawn, height } = drawLegend(0, 12, layout.width);
    const legend = inSvg(layout.width, height, 'Legend', '', drawn);
    return { ...picture, svg: inSvg(layout.width, layout.height, title, subtitle.join(' '), body), legend };
  }
  const head =
    ink('panel', `<rect width="${layout.width}" height="${layout.height}" rx="10" fill="currentColor"/>`) +
    ink('text', write(title, 24, 36, { size: 13, bold: true, maxWidth: layout.width - 48 })) +
    ink('muted', subtitle.map((text, i) => write(text, 24, 58 + 16 * i, { maxWidth: 640 })).join(''));
  const { drawn } = drawLegend(layout.legend.left, layout.legend.top, layout.width - layout.legend.left);
  return { ...picture, svg: inSvg(layout.width, layout.height, title, subtitle.join(' '), head + body + drawn), legend: null };

  function inSvg(w: number, h: number, name: string, about: string, drawn: string): string {
    return (
      `<svg xmlns="http://www.w3.org/2000/svg" width="${w}" height="${h}" viewBox="0 0 ${w} ${h}" role="img">` +
      `<title>${escapeXml(name)}</title><desc>${escapeXml(about)}</desc>${inkStyle(ground)}${drawn}</svg>\n`
    );
  }

  /** The middle of a point's mark: in the plot, or among those with another outcome. */
  function placeOf(point: DiagramPoint): { x: number; y: number } {
    return { x: good(point) ? x.at(point.error) : failedX(point), y: y.at(point.cost) };
  }

  function drawGround(): string {
    const rules: string[] = [];
    const texts: string[] = [];
    for (const power of decades(x, layout.room.x)) {
      const at = x.at(10 ** power);
      rules.push(line(at, PLOT.top, at, PLOT.bottom));
      texts.push(write(powerOfTen(power), at, PLOT.bottom + 19, { anchor: 'middle' }));
    }
    for (const power of decades(y, layout.room.y)) {
      const at = y.at(10 ** power);
      rules.push(line(PLOT.left, at, PLOT.right, at));
      texts.push(write(powerOfTen(power), PLOT.left - 9, at + 4, { anchor: 'end' }));
    }
    texts.push(
      write('error, px', (PLOT.left + PLOT.right) / 2, PLOT.bottom + (layout.legend === null ? 36 : 44), {
        anchor: 'middle',
        size: 9,
      }),
    );
    const middle = (PLOT.top + PLOT.bottom) / 2;
    texts.push(
      layout.legend === null
        ? `<g transform="rotate(-90 10 ${middle})">${write('us a second of play', 10, middle, { anchor: 'middle', size: 8 })}</g>`
        : `<g transform="rotate(-90 26 ${middle})">${write('microseconds per simulated second', 26, middle, { anchor: 'middle', size: 9 })}</g>`,
    );
    if (layout.legend !== null) {
      const [ax, ay] = [PLOT.left + 16, PLOT.bottom - 16];
      texts.push(write('faster, more exact', ax + 18, ay - 8, { size: 7.5 }));
      texts.push(line(ax + 14, ay - 14, ax, ay, 'stroke-width="1.4"'), line(ax, ay, ax + 7, ay, 'stroke-width="1.4"'));
      texts.push(line(ax, ay, ax, ay - 7, 'stroke-width="1.4"'));
    }
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
      [1, layout.legend === null ? '1 px' : 'one pixel'],
    ] as const;
    let free = PLOT.left + 40;
    for (const [value, text] of marks) {
      const at = x.at(value);
      if (at <= PLOT.left + 40 || at >= PLOT.right) continue;
      rules.push(line(at, PLOT.top - 6, at, PLOT.bottom, 'stroke-width="2"'));
      const half = textWidth(text, 7.5) / 2;
      if (at - half > free) texts.push(write(text, at, PLOT.top - 12, { anchor: 'middle', size: 7.5 }));
      free = at + half + 4;
    }
    if (shade !== '') texts.push(write('rounding', PLOT.left + 2, PLOT.top - 12, { size: 7.5 }));
    return ink('shade', shade) + ink('rule', rules.join('')) + ink('muted', texts.join(''));
  }

  /** Where a point stands among those with another outcome: by how many runs have it, or by when the only one ends. */
  function failedX({ failures, time }: DiagramPoint): number {
    const share = runs > 1 ? failures / mostFailures : latest > earliest ? (time - earliest) / (latest - earliest) : 0.5;
    return FAILED.left + 8 + share * (FAILED.right - FAILED.left - 16);
  }

  function drawFailures(): string {
    const { left, right } = FAILED;
    const middle = (left + right) / 2;
    const isWide = layout.legend !== null;
    const texts = [
      write('another', middle, PLOT.top - (isWide ? 26 : 20), { anchor: 'middle', size: 7.5 }),
      write('outcome', middle, PLOT.top - (isWide ? 12 : 8), { anchor: 'middle', size: 7.5 }),
    ];
    const values = runs > 1 ? [0, mostFailures] : latest > earliest ? [earliest, latest] : [earliest];
    // as many digits as tell the ends apart
    const digits = [0, 1, 2].find((count) => new Set(values.map((value) => value.toFixed(count))).size === values.length) ?? 3;
    for (const [i, value] of values.entries()) {
      const at = values.length === 1 ? middle : i === 0 ? left + 1 : right - 1;
      const anchor = values.length === 1 ? 'middle' : i === 0 ? 'start' : 'end';
      texts.push(write(value.toFixed(digits), at, PLOT.bottom + 19, { anchor, size: 7.5 }));
    }
    const label = runs > 1 ? `of ${runs} runs` : 'ends at, s';
    texts.push(write(label, middle, PLOT.bottom + (isWide ? 44 : 36), { anchor: 'middle', size: isWide ? 9 : 7.5 }));
    const box = `<rect x="${left}" y="${PLOT.top}" width="${num(right - left)}" height="${PLOT.bottom - PLOT.top}" fill="currentColor"/>`;
    const axis = line(left, PLOT.bottom, right, PLOT.bottom, 'stroke-width="1.4"');
    return ink('shade', box) + ink('muted', texts.join('') + axis);
  }

  /** Settings that nothing cheaper is as exact as, joined. */
  function drawFront(): string {
    const places = (best?.front ?? []).map((point) => [x.at(point.error), y.at(point.cost)] as const);
    if (places.length === 0) return '';
    return ink('text', `<path d="${polyline(places)}" fill="none" stroke="currentColor" ${FRONT}/>`);
  }

  /** Lines from the setting in use to both axes, and rings around it. */
  function drawUsed(): string {
    const own = points.filter(({ label }) => label !== null && label === used);
    return ink(
      'text',
      own
        .map((point) => {
          const at = placeOf(point);
          const cross =
            own.length === 1 && good(point)
              ? line(PLOT.left, at.y, PLOT.right, at.y, CROSS) + line(at.x, PLOT.top, at.x, PLOT.bottom, CROSS)
              : '';
          return cross + drawRings(at.x, at.y);
        })
        .join(''),
    );
  }

  function drawRings(cx: number, cy: number): string {
    return [8.5, 12.5]
      .map((r) => `<circle cx="${num(cx)}" cy="${num(cy)}" r="${r}" fill="none" stroke="currentColor" stroke-width="2"/>`)
      .join('');
  }

  function drawLine({ kind, faint, points: own }: DiagramLine): string {
    const places = own.filter(good).map((p) => [x.at(p.error), y.at(p.cost)] as const);
    const width = faint ? 'stroke-width="1.1" stroke-dasharray="3 3" opacity="0.75"' : 'stroke-width="1.8"';
    const r = faint ? 3.2 : 5.2;
    let drawn = places.length > 1 ? `<path d="${polyline(places)}" fill="none" stroke="currentColor" ${width}/>` : '';
    for (const point of own) {
      const at = y.at(point.cost);
      let mark = good(point) ? drawMark(kind, x.at(point.error), at, r, point.failures > 0) : '';
      if (best?.ofFamilies.has(point)) mark += drawBest(x.at(point.error), at);
      if (point.failures > 0) mark += drawMark(kind, failedX(point), at, r, true);
      // a viewer of pictures names what is pointed at, or has the focus
      drawn += `<g role="img" tabindex="0"><title>${escapeXml(point.words)}</title>${mark}</g>`;
      if (point.label === null || !good(point)) continue;
      if (!faint && kind !== 'peer' && point.label !== used) {
        drawn += `<circle cx="${num(x.at(point.error))}" cy="${num(at)}" r="9" fill="none" stroke="currentColor" stroke-width="1.4"/>`;
      }
      if (point.worseError === null || kind === 'peer') continue;
      const to = x.at(point.worseError);
      drawn += line(x.at(point.error), at, to, at, 'stroke-width="1.2"') + line(to, at - 4, to, at + 4, 'stroke-width="1.2"');
    }
    return ink(kind, drawn);
  }

  function drawLabels(): string {
    const wanted = lines.flatMap(({ kind, points: own }) =>
      own.flatMap((p) => {
        const at = { kind, x: good(p) ? x.at(p.error) : failedX(p), y: y.at(p.cost) };
        if (p.label !== null) {
          // each run has a point of its own: the first one is named
          if (points.some((other) => other !== p && other.label === p.label && points.indexOf(other) < points.indexOf(p)))
            return [];
          const from = p.label === used ? RINGED : 0;
          const text = p.label === used ? `in use: ${p.label}` : p.label;
          return [{ ...at, text, from, style: { size: p.label === used ? 9 : 8.5, bold: kind !== 'peer' } }];
        }
        return p.note === null || !good(p) || layout.legend === null
          ? []
          : [{ ...at, text: p.note, from: 0, style: { size: 7 } }];
      }),
    );
    // Names are placed first and get the better places.
    wanted.sort((a, b) => b.style.size - a.style.size);
    const taken = lines.flatMap(alongLine);
    const within = { left: PLOT.left, right: FAILED.right, top: PLOT.top, bottom: PLOT.bottom };
    const placed = placeLabels(
      wanted.map((label) => ({ ...label, size: label.style.size })),
      taken,
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
  function alongLine({ points: own }: DiagramLine): (readonly [number, number])[] {
    const places = own.filter(good).map((p) => [x.at(p.error), y.at(p.cost)] as const);
    const between = places.slice(1).flatMap(([toX, toY], i) => {
      const [fromX, fromY] = places[i];
      const count = Math.floor(Math.hypot(toX - fromX, toY - fromY) / 8);
      return Array.from({ length: count }, (_, k) => {
        const part = (k + 1) / (count + 1);
        return [fromX + part * (toX - fromX), fromY + part * (toY - fromY)] as const;
      });
    });
    const failed = own.filter((p) => p.failures > 0).map((p) => [failedX(p), y.at(p.cost)] as const);
    return [...places, ...between, ...failed];
  }

  /** What marks and lines stand for, in as many columns as there is room for. */
  function drawLegend(left: number, top: number, room: number): { readonly drawn: string; readonly height: number } {
    const own = lines.filter(({ name, kind }, i) =>
      lines.slice(0, i).every((other) => (kind === 'peer' ? other.kind !== kind : other.name !== name)),
    );
    const entries: { readonly ink: Ink; readonly sign: (x: number, y: number) => string; readonly text: string }[] = own.map(
      ({ name, kind, faint }) => ({
        ink: kind,
        sign: (sx, sy) =>
          line(sx, sy, sx + 26, sy, faint ? 'stroke-width="1.1" stroke-dasharray="3 3"' : 'stroke-width="1.8"') +
          drawMark(kind, sx + 13, sy, faint ? 3.2 : 5.2, false),
        text: kind === 'peer' ? 'other engines' : name,
      }),
    );
    if (best !== undefined) {
      entries.push({
        ink: 'text',
        sign: (sx, sy) => line(sx, sy, sx + 26, sy, FRONT),
        text: 'nothing cheaper is as exact',
      });
      entries.push({ ink: 'text', sign: (sx, sy) => drawBest(sx + 13, sy), text: 'best of its integrator' });
    }
    if (used !== null) entries.push({ ink: 'text', sign: (sx, sy) => drawRings(sx + 13, sy), text: 'in use' });
    if (mostFailures > 0)
      entries.push({
        ink: 'muted',
        sign: (sx, sy) => drawMark('rk4', sx + 13, sy, 5.2, true),
        text: runs > 1 ? 'hollow: some runs end otherwise' : 'hollow: another outcome',
      });
    const isWide = layout.legend !== null;
    const columns = isWide ? 1 : Math.max(1, Math.floor(room / 125));
    const step = 25;
    const rows = Math.ceil(entries.length / columns);
    const width = room / columns - 35;
    let drawn = entries
      .map((entry, i) => {
        const [sx, sy] = [left + Math.floor(i / rows) * (room / columns), top + step * (i % rows)];
        const text = wrapText(entry.text, 7.5, width - 6).map((words, k, all) =>
          write(words, sx + 35, sy + 4 + 12 * k - 6 * (all.length - 1), { size: 7.5 }),
        );
        return ink(entry.ink, entry.sign(sx + 2, sy)) + ink('text', text.join(''));
      })
      .join('');
    const notes = runs > 1 ? ['marks: median run,', 'whiskers: to the', '90th percentile'] : [];
    const bottom = top + step * rows;
    const texts = isWide ? notes : notes.length > 0 ? [notes.join(' ')] : [];
    drawn += ink(
      'muted',
      texts.map((note, i) => write(note, left + 2, bottom + 6 + 16 * i, { size: 7.5, maxWidth: room })).join(''),
    );
    return { drawn, height: bottom + 16 * texts.length };
  }
}
