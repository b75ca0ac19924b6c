import type { Run } from '../../engine/index.ts';
import { type Level, type ObjectKind, placesIn, rulesOf } from '../../schema/index.ts';
import { drawBackground, drawGradients, drawRanges } from '../background.ts';
import { drawCaption } from '../caption.ts';
import { drawContact } from '../contact.ts';
import { IN_PICTURE } from '../kinds/index.ts';
import type { LegendEntry } from '../legend.ts';
import { drawObjects } from '../objects.ts';
import { drawStartFigure } from '../run.ts';
import { drawSeveral, type NamedRun } from '../several.ts';
import { THEMES, type Theme } from '../theme.ts';
import { frame, place, type Thing, type View } from '../view.ts';
import { type PathPoint, stretchesOf } from '../way.ts';
import { escapeXml, num } from '../xml.ts';

/** An object that differs between two versions of a level; null where it is not there. */
export interface Mark {
  readonly kind: ObjectKind;
  readonly before: Thing | null;
  readonly after: Thing | null;
}

/** What {@link renderComparison} draws besides the two versions. */
interface ComparisonOptions {
  /** The runs of the two versions, with labels. */
  readonly runs?: readonly NamedRun[];
  /** Runs for which the picture makes room and which it does not draw. */
  readonly room?: readonly { readonly run: Run }[];
  /** Width of the picture, px; 960 by default. */
  readonly width?: number;
  /** The colours; `dark` by default. */
  readonly theme?: Theme['name'];
  readonly title?: string;
  /** A sentence below the title. */
  readonly note?: string;
  /** Whether to draw title, timelines and legend; true by default. */
  readonly words?: boolean;
}

/** A picture, and where the level lies in it: `x` and `y` are the place of its origin, in units of the picture. */
export interface Comparison {
  readonly svg: string;
  readonly view: {
    readonly x: number;
    readonly y: number;
    readonly scale: number;
    readonly width: number;
    readonly height: number;
  };
}

const UNITS = 960;

/** Moves shorter than this have no arrow, units of the picture. */
const SHORTEST_ARROW = 5;

/** Radius of the drawing of an object that has none, px of the level. */
const FIGURE = 18;

/**
 * Draws two versions of a level in one picture: the later one, and over it what differs. Objects that were moved or removed are
 * drawn faintly where they were; an arrow leads to their new place.
 * @param before the earlier version
 * @param after the later version
 * @param marks the objects that differ
 */
export function renderComparison(
  before: Level,
  after: Level,
  marks: readonly Mark[],
  options: ComparisonOptions = {},
): Comparison {
  const { runs = [], room = [], width = UNITS, title = after.name, note = '', words = true } = options;
  const theme = THEMES[options.theme ?? 'dark'];
  const ways = runs.map(({ run }) => stretchesOf(run));
  const around = [...ways, ...room.map(({ run }) => stretchesOf(run))];
  const view = frame(after, [...around.flat().flatMap(({ points }) => points), ...cornersOf(marks, before)], UNITS);
  const gone = marks.filter((mark) => mark.before !== null);
  const scene = [
    drawBackground(view, theme, after),
    drawRanges(view, theme, after),
    `<g opacity=".38">${gone.map((mark, i) => drawGhost(view, theme, before, mark, i)).join('')}</g>`,
    drawObjects(view, theme, after, width),
    marks.map((mark) => drawMark(view, theme, mark)).join(''),
  ];
  if (runs.length > 0) {
    scene.push(drawSeveral(view, theme, ways, runs));
    for (const { run } of runs) if (run.outcome !== 'completed') scene.push(drawContact(view, theme, after, run));
  }
  scene.push(drawStartFigure(view, theme, after));
  const signs = words ? signsOf(theme, marks) : [];
  const caption = words
    ? drawCaption(after, theme, view.height, UNITS, { title, run: undefined, holds: undefined, ways: runs, note, signs })
    : { svg: '', height: 0 };
  const height = view.height + caption.height;
  const svg =
    `<svg xmlns="http://www.w3.org/2000/svg" width="${num(width)}" height="${num((height * width) / UNITS)}" viewBox="0 0 ${UNITS} ${num(height)}" role="img">` +
    `<title>${escapeXml(title)}</title><desc>${escapeXml(note)}</desc>${drawGradients(theme)}` +
    `<clipPath id="gq-scene"><rect width="${UNITS}" height="${num(view.height)}"/></clipPath>` +
    `<g data-kind="scene" clip-path="url(#gq-scene)">${scene.join('')}</g>${caption.svg}</svg>\n`;
  return { svg, view: { x: view.x(0), y: view.y(0), scale: view.scale, width: UNITS, height: view.height } };
}

/** Places of the earlier version that the picture has to contain. */
function cornersOf(marks: readonly Mark[], { astronaut }: Level): PathPoint[] {
  const corners = marks.flatMap(({ kind, before }): PathPoint[] => {
    if (before === null) return [];
    const radius = before.radius ?? FIGURE;
    return placesIn(kind, before).flatMap(({ x, y }): PathPoint[] => [
      [x - radius, y - radius],
      [x + radius, y + radius],
    ]);
  });
  return [...corners, [astronaut.x, astronaut.y]];
}

/** An object as it was. */
function drawGhost(view: View, theme: Theme, level: Level, { kind, before }: Mark, index: number): string {
  if (before === null) return '';
  const { draw } = IN_PICTURE[kind];
  return placesIn(kind, before)
    .map((at, nth) => {
      const look = { object: before, place: nth, radius: before.radius ?? 0, index, theme, rules: rulesOf(level) };
      return place(view, 'ghost', index, at, draw(look));
    })
    .join('');
}

/** Least radius of a ring, units. */
const LEAST_RING = 7;

const ring = (x: number, y: number, r: number, colour: string, dash: string): string =>
  `<circle cx="${num(x)}" cy="${num(y)}" r="${num(Math.max(LEAST_RING, r))}" fill="none" stroke="${colour}" stroke-width="2"${dash === '' ? '' : ` stroke-dasharray="${dash}"`}/>`;

/** What marks the difference: rings, crosses, arrows. No sign is told from another by its colour alone. */
function drawMark(view: View, theme: Theme, { kind, before, after }: Mark): string {
  const radius = (thing: Thing): number => (thing.radius ?? FIGURE) * view.scale + 4;
  const places = (thing: Thing) => placesIn(kind, thing).map(({ x, y }) => [view.x(x), view.y(y)] as const);
  if (after === null) {
    if (before === null) return '';
    const r = Math.max(LEAST_RING, radius(before)) * 0.7;
    const crosses = places(before).map(
      ([x, y]) =>
        `${ring(x, y, radius(before), theme.bad, '3 4')}<path d="M${num(x - r)} ${num(y - r)}L${num(x + r)} ${num(y + r)}M${num(x - r)} ${num(y + r)}L${num(x + r)} ${num(y - r)}" stroke="${theme.bad}" stroke-width="2"/>`,
    );
    return `<g data-kind="removed">${crosses.join('')}</g>`;
  }
  if (before === null) {
    const rings = places(after).map(
      ([x, y]) => ring(x, y, radius(after), theme.good, '') + ring(x, y, radius(after) + 4, theme.good, ''),
    );
    return `<g data-kind="added">${rings.join('')}</g>`;
  }
  const [from, to] = [places(before), places(after)];
  const drawn = to.map(([x, y], i) => {
    const [bx, by] = from[i];
    const isMoved = Math.hypot(x - bx, y - by) >= SHORTEST_ARROW;
    const old = isMoved || before.radius !== after.radius ? ring(bx, by, radius(before), theme.muted, '3 4') : '';
    return `${old}${ring(x, y, radius(after), theme.gun, '8 3')}${isMoved ? arrow(bx, by, x, y, theme) : ''}`;
  });
  return `<g data-kind="changed">${drawn.join('')}</g>`;
}

function arrow(bx: number, by: number, x: number, y: number, theme: Theme): string {
  const length = Math.hypot(x - bx, y - by);
  const [ux, uy] = [(x - bx) / length, (y - by) / length];
  const head = Math.min(9, 0.6 * length);
  const side = 0.5 * head;
  const at = (back: number, across: number): string => `${num(x - back * ux - across * uy)} ${num(y - back * uy + across * ux)}`;
  const d = `M${num(bx)} ${num(by)}L${num(x)} ${num(y)}M${at(head, side)}L${num(x)} ${num(y)}L${at(head, -side)}`;
  return (
    `<path data-kind="arrow" d="${d}" fill="none" stroke="${theme.halo}" stroke-width="5" stroke-opacity=".6"/>` +
    `<path d="${d}" fill="none" stroke="${theme.gun}" stroke-width="2" stroke-linecap="round" stroke-linejoin="round"/>`
  );
}

function signsOf(theme: Theme, marks: readonly Mark[]): LegendEntry[] {
  const signs: LegendEntry[] = [];
  if (marks.some(({ before, after }) => before !== null && after !== null)) {
    signs.push({ label: 'changed, and where it was', icon: `${ring(0, 0, 7, theme.gun, '8 3')}` });
  }
  if (marks.some(({ before }) => before === null)) {
    signs.push({ label: 'added', icon: ring(0, 0, 7, theme.good, '') + ring(0, 0, 10, theme.good, '') });
  }
  if (marks.some(({ after }) => after === null)) {
    signs.push({
      label: 'removed',
      icon: `${ring(0, 0, 7, theme.bad, '3 4')}<path d="M-5 -5L5 5M-5 5L5 -5" stroke="${theme.bad}" stroke-width="2"/>`,
    });
  }
  return signs;
}

/** The path of a run, as the data of an SVG path in units of a picture; and whether each stretch holds the gun. */
export const pathOf = (run: Run, view: Comparison['view']): { readonly held: string; readonly free: string } => {
  const d = (held: boolean): string =>
    stretchesOf(run)
      .filter((stretch) => stretch.held === held)
      .map(
        ({ points }) => `M${points.map(([x, y]) => `${num(view.x + x * view.scale)} ${num(view.y + y * view.scale)}`).join('L')}`,
      )
      .join('');
  return { held: d(true), free: d(false) };
};
