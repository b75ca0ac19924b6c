import type { Run } from '../engine/index.ts';
import { drawText, wrapText } from './text.ts';
import type { Theme } from './theme.ts';
import { lineThrough, type View } from './view.ts';
import { heldTimes, type PathPoint, positionAt, type Stretch, stretchesOf } from './way.ts';
import { num } from './xml.ts';

/** One of several runs in a picture. */
export interface NamedRun {
  readonly run: Run;
  /** The text beside its timeline: its name and its length. */
  readonly label: string;
  /** When its path glows, s; null or left out: it does not. */
  readonly glows?: number | null;
}

const BADGE = 8;

/** Draws several paths through a level, each with a colour and a number. */
export function drawSeveral(view: View, theme: Theme, ways: readonly (readonly Stretch[])[], runs: readonly NamedRun[]): string {
  const d = ({ points }: Stretch): string => lineThrough(view, points);
  const halo = `<path d="${ways.flat().map(d).join('')}" stroke="${theme.halo}" stroke-width="6" stroke-opacity=".5"/>`;
  const lines = ways.map((stretches, i) => {
    const held = stretches.filter((s) => s.held).map(d);
    const coasting = stretches.filter((s) => !s.held).map(d);
    return (
      `<g data-kind="way" data-index="${i}" stroke="${wayColor(theme, i)}"><path d="${held.join('')}" stroke-width="4"/>` +
      `<path d="${coasting.join('')}" stroke-width="1.6"/></g>`
    );
  });
  const badges = placeBadges(view, runs).map(([x, y], i) => drawBadge(theme, i, x, y));
  const glows = runs.map(({ run, glows: time }, i) => (time == null ? '' : drawGlow(view, theme, i, positionAt(run, time))));
  return `<g data-kind="ways" fill="none" stroke-linecap="round" stroke-linejoin="round">${halo}${lines.join('')}</g>${glows.join('')}${badges.join('')}`;
}

const wayColor = ({ ways }: Theme, index: number): string => ways[index % ways.length];

function drawGlow(view: View, theme: Theme, index: number, [x, y]: PathPoint): string {
  const discs = [
    [13, 0.2],
    [8, 0.35],
    [3.5, 1],
  ].map(([r, opacity]) => `<circle cx="${num(view.x(x))}" cy="${num(view.y(y))}" r="${r}" fill-opacity="${opacity}"/>`);
  return `<g data-kind="glow" data-index="${index}" fill="${wayColor(theme, index)}">${discs.join('')}</g>`;
}

function drawBadge(theme: Theme, index: number, x: number, y: number): string {
  const color = wayColor(theme, index);
  return (
    `<circle data-kind="badge" cx="${num(x)}" cy="${num(y)}" r="${BADGE}" fill="${theme.halo}" stroke="${color}" stroke-width="1.6"/>` +
    drawText(String(index + 1), x, y + 3.6, { size: 7.2, color, anchor: 'middle', bold: true })
  );
}

/** Finds a place on each path for its number, as far as possible from its ends, from other numbers and from other paths. */
function placeBadges(view: View, runs: readonly NamedRun[]): PathPoint[] {
  const tracks = runs.map(({ run }) => {
    const count = 60;
    return Array.from({ length: count + 1 }, (_, k): PathPoint => {
      const [x, y] = positionAt(run, (run.trajectory.duration * k) / count);
      return [view.x(x), view.y(y)];
    });
  });
  const placed: PathPoint[] = [];
  for (const [i, track] of tracks.entries()) {
    const others = tracks.flatMap((other, k) => (k === i ? [] : other));
    const room = ([x, y]: PathPoint): number => {
      const near = (points: readonly PathPoint[]): number =>
        Math.min(120, ...points.map(([px, py]) => Math.hypot(px - x, py - y)));
      return near(others) + 2 * near([track[0], track[track.length - 1], ...placed]);
    };
    // Not at the ends, where all paths meet.
    const inner = track.slice(6, -6);
    placed.push(inner.reduce((best, p) => (room(p) > room(best) ? p : best), inner[Math.floor(inner.length / 2)]));
  }
  return placed;
}

const ROW = 27;
const BAR = 7;
const LABEL = 6.8;
/** Distance between two lines of a label, in units. */
const LINE = 13;

/** Draws what stands below the scene: a label and a timeline for each run, all on one scale of time. */
export function drawSeveralTimelines(
  theme: Theme,
  runs: readonly NamedRun[],
  x: number,
  y: number,
  width: number,
): { readonly svg: string; readonly height: number } {
  const longest = Math.max(...runs.map(({ run }) => run.time), 1e-9);
  const lines = runs.map(({ label }) => wrapText(label, LABEL, width - 26));
  let end = y;
  const tops = lines.map(({ length }) => {
    const top = end;
    end += ROW + LINE * (length - 1);
    return top;
  });
  const rows = runs.map(({ run }, i) => {
    const top = tops[i];
    const left = x + 26;
    const at = (time: number): number => left + ((width - 26) * time) / longest;
    const color = wayColor(theme, i);
    const held = heldTimes(run)
      .map(
        ([from, to]) =>
          `<rect x="${num(at(from))}" y="${num(top)}" width="${num(Math.max(1, at(to) - at(from)))}" height="${BAR}" rx="2"/>`,
      )
      .join('');
    const words = lines[i]
      .map((line, k) => drawText(line, left, top + BAR + 11 + LINE * k, { size: LABEL, color: theme.muted }))
      .join('');
    return (
      `<g data-kind="timeline" data-index="${i}">${drawBadge(theme, i, x + BADGE, top + BAR)}` +
      `<rect x="${num(left)}" y="${num(top)}" width="${num(at(run.time) - left)}" height="${BAR}" rx="2" fill="${theme.rule}"/>` +
      `<g fill="${color}">${held}</g>${words}</g>`
    );
  });
  return { svg: rows.join(''), height: end - y + 8 };
}

const CROSS = 'm-3-3l6 6m0-6l-6 6';

/** Draws her paths for shifted presses and releases: those that still reach the black hole, and those that fail. */
export function drawFan(view: View, theme: Theme, runs: readonly Run[]): string {
  const draw = (completes: boolean): string => {
    let d = '';
    let ends = '';
    for (const run of runs) {
      if ((run.outcome === 'completed') !== completes) continue;
      for (const { points } of stretchesOf(run)) d += lineThrough(view, points);
      if (!completes) ends += `M${num(view.x(run.final.x))} ${num(view.y(run.final.y))}${CROSS}`;
    }
    if (d === '') return '';
    // Dashes distinguish them without colour.
    const dash = completes ? '' : ' stroke-dasharray="5 3"';
    const crosses = ends === '' ? '' : `<path d="${ends}" stroke-width="1.6" stroke-opacity=".9"/>`;
    return (
      `<g data-kind="fan-${completes ? 'completed' : 'failed'}" stroke="${completes ? theme.good : theme.bad}">` +
      `<path d="${d}" stroke-width="1" stroke-opacity="${completes ? 0.35 : 0.5}"${dash}/>${crosses}</g>`
    );
  };
  return `<g data-kind="fan" fill="none" stroke-linecap="round" stroke-linejoin="round">${draw(true)}${draw(false)}</g>`;
}

/** The icons of both kinds of paths, for the legend. */
export const drawFanSign = (theme: Theme, completes: boolean): string =>
  `<path d="M-10 4C-4-5 4-5 10 0" fill="none" stroke="${completes ? theme.good : theme.bad}" stroke-width="1.6" stroke-linecap="round"${completes ? '' : ' stroke-dasharray="5 3"'}/>`;
