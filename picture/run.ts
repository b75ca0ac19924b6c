import { boxOf, type Run, STATE_SIZE } from '../engine/index.ts';
import { type Level, rulesOf } from '../schema/index.ts';
import { drawAlienWay } from './alien-way.ts';
import { drawContact } from './contact.ts';
import { drawAstronaut } from './kinds/index.ts';
import { place } from './place.ts';
import type { Point } from './simplify.ts';
import { startLabelAt } from './start.ts';
import { drawText } from './text.ts';
import type { Theme } from './theme.ts';
import type { View } from './view.ts';
import { alienWay, heldTimes, positionAt, type Stretch } from './way.ts';
import { num } from './xml.ts';

// a dot a second for a run of a minute; a longer one would be all dots
const MOST_DOTS = 90;

// numbers at the presses help as long as they don't cover each other
const MOST_NUMBERS = 12;

/** Her way: coasting thin, gun held thick, in a halo that keeps it legible on anything it crosses. */
export function drawWay(view: View, theme: Theme, stretches: readonly Stretch[]): string {
  const d = ({ points }: Stretch): string => `M${points.map(([x, y]) => `${num(view.x(x))} ${num(view.y(y))}`).join('L')}`;
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

/** A dot each second, a larger one each fifth. */
export function drawSeconds(view: View, theme: Theme, run: Run): string {
  const end = run.trajectory.duration;
  const every = Math.max(1, Math.ceil(end / MOST_DOTS));
  let dots = '';
  let [lastX, lastY] = positionAt(run, 0);
  for (let time = every; time < end; time += every) {
    const [x, y] = positionAt(run, time);
    // where she is slow they shrink, or they would cover her way
    const room = 0.3 * Math.hypot(x - lastX, y - lastY) * view.scale;
    const radius = Math.max(0.8, Math.min(room, time % (5 * every) === 0 ? 4 : 2.7));
    dots += `<circle cx="${num(view.x(x))}" cy="${num(view.y(y))}" r="${num(radius)}"/>`;
    [lastX, lastY] = [x, y];
  }
  return `<g data-kind="seconds" fill="${theme.text}" stroke="${theme.halo}" stroke-width="1">${dots}</g>`;
}

/** A faint line from her to each asteroid as it becomes the target. */
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

/** The number of each press beside where it happened: off her way, and off the other numbers. */
export function drawPresses(view: View, theme: Theme, level: Level, run: Run): string {
  const presses = heldTimes(run);
  if (presses.length > MOST_NUMBERS) return '';
  const state = new Float64Array(STATE_SIZE);
  const numbersAt: Point[] = [];
  const start: Point = [view.x(level.astronaut.x), view.y(level.astronaut.y)];
  const apart = ([ax, ay]: Point, [bx, by]: Point, distance: number): boolean => Math.hypot(ax - bx, ay - by) >= distance;
  const isFree = (p: Point): boolean =>
    apart(p, start, 18 * view.scale + 7) &&
    apart(p, startLabelAt(view, level, run), 24) &&
    numbersAt.every((n) => apart(p, n, 17));
  const numbers = presses.map(([time], i) => {
    run.trajectory.at(time, state);
    const [x, y, vx, vy, cos, sin] = state;
    // square to her way, on the side that the gun doesn't pull to; at rest square to the pull
    const speed = Math.hypot(vx, vy);
    const [nx, ny] = speed < 1 ? [-sin, cos] : [-vy / speed, vx / speed];
    const side = nx * cos + ny * sin > 1e-6 ? -1 : 1;
    const at = (distance: number): Point => [view.x(x) + side * distance * nx, view.y(y) + side * distance * ny];
    const [px, py] = [16, -16, 34, -34, 52, -52].map(at).find(isFree) ?? at(16);
    numbersAt.push([px, py]);
    return (
      `<circle cx="${num(px)}" cy="${num(py)}" r="7.6" fill="${theme.halo}" stroke="${theme.gun}" stroke-width="1.2"/>` +
      drawText(String(i + 1), px, py + 3.6, { size: 7.2, color: theme.gun, anchor: 'middle', bold: true })
    );
  });
  return `<g data-kind="presses">${numbers.join('')}</g>`;
}

/** Where aliens went, those that woke. */
export function drawAlienWays(view: View, theme: Theme, level: Level, run: Run): string {
  const woke = new Set<number>();
  const { alienSight } = rulesOf(level);
  // one that is awake from the start has no event that says so
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

/** How the run ended: her at the end, at her angle, and the sign of what happened. */
export function drawEnd(view: View, theme: Theme, level: Level, run: Run): string {
  const { x, y, cos, sin } = run.final;
  const color = run.outcome === 'completed' ? theme.good : run.outcome === 'timeout' ? theme.coast : theme.bad;
  const angle = num((Math.atan2(sin, cos) * 180) / Math.PI);
  const figure = `<g transform="rotate(${angle})">${drawAstronaut(theme, color, boxOf(rulesOf(level)))}</g>`;
  return place(view, 'astronaut-end', 0, { x, y }, figure) + drawContact(view, theme, level, run);
}
