import { boxOf, type Run, STATE_SIZE } from '../engine/index.ts';
import { type Level, rulesOf } from '../schema/index.ts';
import { drawContact } from './contact.ts';
import { ALIEN_INK, drawAstronaut } from './kinds/index.ts';
import { drawText } from './text.ts';
import type { Theme } from './theme.ts';
import { lineThrough, place, type View } from './view.ts';
import { alienWay, heldTimes, type PathPoint, positionAt, type Stretch } from './way.ts';
import { num } from './xml.ts';

// One dot per second suits a run of a minute; a longer one would be covered with dots.
const MOST_DOTS = 90;

// Numbers at the presses help as long as they do not cover each other.
const MOST_NUMBERS = 12;

/**
 * Draws her path, thin while she drifts and thick while the gun is held. A halo keeps it legible on everything that it crosses.
 */
export function drawWay(view: View, theme: Theme, stretches: readonly Stretch[]): string {
  const d = ({ points }: Stretch): string => lineThrough(view, points);
  const all = stretches.map(d).join('');
  const lines = stretches
    .map((stretch) =>
      stretch.held
        ? `<path data-kind="held" d="${d(stretch)}" stroke="${theme.gun}" stroke-width="4.6"/>`
        : `<path data-kind="coasting" d="${d(stretch)}" stroke="${theme.coast}" stroke-width="1.5"/>`,
    )
    .join('');
  return (
    `<g data-kind="way" fill="none" stroke-linecap="round" stroke-linejoin="round">` +
    `<path d="${all}" stroke="${theme.halo}" stroke-width="7" stroke-opacity=".55"/>${lines}</g>`
  );
}

/** Draws a dot for each second, and a larger one for every fifth. */
export function drawSeconds(view: View, theme: Theme, run: Run): string {
  const end = run.trajectory.duration;
  const every = Math.max(1, Math.ceil(end / MOST_DOTS));
  let dots = '';
  let [lastX, lastY] = positionAt(run, 0);
  for (let time = every; time < end; time += every) {
    const [x, y] = positionAt(run, time);
    // Where she is slow the dots shrink, or they would cover her path.
    const room = 0.3 * Math.hypot(x - lastX, y - lastY) * view.scale;
    const radius = Math.max(0.8, Math.min(room, time % (5 * every) === 0 ? 4 : 2.7));
    dots += `<circle cx="${num(view.x(x))}" cy="${num(view.y(y))}" r="${num(radius)}"/>`;
    [lastX, lastY] = [x, y];
  }
  return `<g data-kind="seconds" fill="${theme.text}" stroke="${theme.halo}" stroke-width="1">${dots}</g>`;
}

/** Draws a faint line from her to each asteroid at the moment when it becomes the target. */
export function drawTethers(view: View, theme: Theme, level: Level, run: Run): string {
  let d = '';
  for (const event of run.events) {
    if (event.type !== 'target') continue;
    const [x, y] = positionAt(run, event.time);
    const target = level.asteroids[event.index];
    d += `M${num(view.x(x))} ${num(view.y(y))}L${num(view.x(target.x))} ${num(view.y(target.y))}`;
  }
  if (d === '') return '';
  return `<path data-kind="tethers" d="${d}" fill="none" stroke="${theme.gun}" stroke-opacity=".5" stroke-width="1.2" stroke-dasharray="2 4" stroke-linecap="round"/>`;
}

/** Draws the number of each press beside its place, away from her path and from other numbers. */
export function drawPresses(view: View, theme: Theme, level: Level, run: Run): string {
  const presses = heldTimes(run);
  if (presses.length > MOST_NUMBERS) return '';
  const state = new Float64Array(STATE_SIZE);
  const numbersAt: PathPoint[] = [];
  const start: PathPoint = [view.x(level.astronaut.x), view.y(level.astronaut.y)];
  const apart = ([ax, ay]: PathPoint, [bx, by]: PathPoint, distance: number): boolean => Math.hypot(ax - bx, ay - by) >= distance;
  const isFree = (p: PathPoint): boolean =>
    apart(p, start, 18 * view.scale + 7) &&
    apart(p, startLabelAt(view, level, run), 24) &&
    numbersAt.every((n) => apart(p, n, 17));
  const numbers = presses.map(([time], i) => {
    run.trajectory.at(time, state);
    const [x, y, vx, vy, cos, sin] = state;
    // Perpendicular to her path, on the side away from the target; at rest perpendicular to the pull.
    const speed = Math.hypot(vx, vy);
    const [nx, ny] = speed < 1 ? [-sin, cos] : [-vy / speed, vx / speed];
    const side = nx * cos + ny * sin > 1e-6 ? -1 : 1;
    const at = (distance: number): PathPoint => [view.x(x) + side * distance * nx, view.y(y) + side * distance * ny];
    const [px, py] = [16, -16, 34, -34, 52, -52].map(at).find(isFree) ?? at(16);
    numbersAt.push([px, py]);
    return (
      `<circle cx="${num(px)}" cy="${num(py)}" r="7.6" fill="${theme.halo}" stroke="${theme.gun}" stroke-width="1.2"/>` +
      drawText(String(i + 1), px, py + 3.6, { size: 7.2, color: theme.gun, anchor: 'middle', bold: true })
    );
  });
  return `<g data-kind="presses">${numbers.join('')}</g>`;
}

/** Draws the paths of the aliens that woke. */
export function drawAlienWays(view: View, theme: Theme, level: Level, run: Run): string {
  const woke = new Set<number>();
  const { alienSight } = rulesOf(level);
  // An alien that is awake at the start has no event for it.
  for (const [i, { x, y }] of level.aliens.entries()) {
    if (Math.hypot(x - level.astronaut.x, y - level.astronaut.y) < alienSight) woke.add(i);
  }
  for (const event of run.events) {
    if (event.type === 'wake') woke.add(event.index);
    if (event.type === 'explosion') for (const alien of event.aliens) woke.add(alien);
  }
  return [...woke]
    .sort((a, b) => a - b)
    .map((i) => {
      const way = alienWay(run, i, level.aliens.length);
      return way === null ? '' : drawAlienWay(view, theme, way.points, level.aliens[i].radius, way.exploded);
    })
    .join('');
}

/** Draws the end of the run: her figure at her angle, and the mark of the outcome. */
export function drawEnd(view: View, theme: Theme, level: Level, run: Run): string {
  const { x, y, cos, sin } = run.final;
  const color = run.outcome === 'completed' ? theme.good : run.outcome === 'timeout' ? theme.coast : theme.bad;
  const angle = num((Math.atan2(sin, cos) * 180) / Math.PI);
  const figure = `<g transform="rotate(${angle})">${drawAstronaut(theme, color, boxOf(rulesOf(level)))}</g>`;
  return place(view, 'astronaut-end', 0, { x, y }, figure) + drawContact(view, theme, level, run);
}

/** Draws the path of an alien that moved, and its last place: a ghost, or a burst if it had exploded. */
function drawAlienWay(
  view: View,
  theme: Theme,
  way: readonly (readonly [number, number])[],
  radius: number,
  exploded: boolean,
): string {
  const points = way.map(([x, y]) => `${num(view.x(x))} ${num(view.y(y))}`).join('L');
  const [x, y] = way[way.length - 1];
  const r = radius * view.scale;
  let burst = '';
  for (let i = 0; i < 12; i++) {
    const [cos, sin] = [Math.cos((i * Math.PI) / 6), Math.sin((i * Math.PI) / 6)];
    const from = i % 2 === 0 ? 0.35 : 0.5;
    burst += `M${num(from * r * cos)} ${num(from * r * sin)}L${num(r * cos)} ${num(r * sin)}`;
  }
  const end = exploded
    ? `<path d="${burst}" stroke-width="2" stroke-linecap="round"/>`
    : `<circle r="${num(r)}" stroke-width="1.2" stroke-dasharray="4 3"/><circle cx="${num(-0.28 * r)}" cy="${num(-0.14 * r)}" r="${num(0.16 * r)}" stroke-width="1.2"/><circle cx="${num(0.28 * r)}" cy="${num(-0.14 * r)}" r="${num(0.16 * r)}" stroke-width="1.2"/>`;
  return (
    `<g data-kind="alien-way" fill="none" stroke="${ALIEN_INK[theme.name]}"><path d="M${points}" stroke-width="1.6" stroke-dasharray=".1 5" stroke-linecap="round"/>` +
    `<g transform="translate(${num(view.x(x))} ${num(view.y(y))})">${end}</g></g>`
  );
}

/** The mark of a collected mineral, around its centre. */
const drawTick = (theme: Theme): string =>
  `<g fill="none" stroke-linecap="round" stroke-linejoin="round"><circle r="11.5" stroke="${theme.good}" stroke-width="1.3"/>` +
  `<path d="M6.5-9.5L9.8-6L16-13.5" stroke="${theme.halo}" stroke-width="5.5"/><path d="M6.5-9.5L9.8-6L16-13.5" stroke="${theme.good}" stroke-width="2.6"/></g>`;

/** Marks each mineral that the run collects. */
export function drawCollected(view: View, theme: Theme, level: Level, run: Run): string {
  const indices = [...new Set(run.minerals.map(({ index }) => index))];
  return indices.map((i) => place(view, 'collected', i, level.minerals[i], drawTick(theme))).join('');
}

// She has left the place of her box after this time, s.
const SOON = 3;

/** The centre of the label beside the start, on the side towards which she does not move. */
function startLabelAt(view: View, level: Level, run: Run | undefined): PathPoint {
  const { x, y } = level.astronaut;
  const leavesDown = run !== undefined && positionAt(run, SOON)[1] > y;
  const off = boxOf(rulesOf(level)).halfHeight * view.scale + 9;
  return [view.x(x), view.y(y) + (leavesDown ? -off : off)];
}

/** Draws the astronaut at the start, upright in her box. */
export const drawStartFigure = (view: View, theme: Theme, level: Level): string =>
  place(view, 'astronaut', 0, level.astronaut, drawAstronaut(theme, theme.muted, boxOf(rulesOf(level))));

/** Draws the astronaut at the start, with a label. */
export function drawStart(view: View, theme: Theme, level: Level, run: Run | undefined): string {
  const [x, y] = startLabelAt(view, level, run);
  const label = drawText('start', x, y + 3.3, { size: 6.5, color: theme.muted, anchor: 'middle' });
  return drawStartFigure(view, theme, level) + label;
}
