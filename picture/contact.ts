import { type Box, boxCircleGap, boxOf, type Run, STATE_SIZE } from '../engine/index.ts';
import { type Level, type Place, placesIn, rulesOf } from '../schema/index.ts';
import { drawAstronaut } from './kinds/index.ts';
import { drawText, textWidth } from './text.ts';
import type { Theme } from './theme.ts';
import { place, thingsOf, type View } from './view.ts';
import { num } from './xml.ts';

/** Her place, and the direction of her box as a unit vector. */
type Pose = Pick<Run['final'], 'x' | 'y' | 'cos' | 'sin'>;

const CROSS = 'M-7-7L7 7M-7 7L7-7';

/**
 * Marks the place where the run ended: a ring at the black hole, a cross in a ring at a hazard, a broken ring where she was
 * lost.
 */
export function drawContact(view: View, theme: Theme, level: Level, run: Run): string {
  const { final, outcome } = run;
  if (outcome === 'timeout') return '';
  const at = outcome === 'lost' ? final : nearestOfBox(boxOf(rulesOf(level)), final, touchedAt(level, run));
  const sign = {
    completed: `<circle r="12" stroke="${theme.good}" stroke-width="2"/><path d="M-5 .5L-1.5 4L5.5-4" stroke="${theme.halo}" stroke-width="6"/><path d="M-5 .5L-1.5 4L5.5-4" stroke="${theme.good}" stroke-width="2.8"/>`,
    collided: `<circle r="14" stroke="${theme.bad}" stroke-width="2"/><path d="${CROSS}" stroke="${theme.halo}" stroke-width="7"/><path d="${CROSS}" stroke="${theme.bad}" stroke-width="3.4"/>`,
    lost: `<circle r="30" stroke="${theme.bad}" stroke-width="2" stroke-dasharray="7 7"/>`,
  }[outcome];
  return (
    `<g data-kind="contact" data-outcome="${outcome}" transform="translate(${num(view.x(at.x))} ${num(view.y(at.y))})" fill="none" ` +
    `stroke-linecap="round" stroke-linejoin="round">${sign}</g>`
  );
}

/** The point of her box nearest to a place: that place, clamped to the box in the box's own axes. */
function nearestOfBox({ halfWidth, halfHeight }: Box, { x, y, cos, sin }: Pose, place: Place): Place {
  const dx = place.x - x;
  const dy = place.y - y;
  const along = Math.max(-halfWidth, Math.min(halfWidth, dx * cos + dy * sin));
  const across = Math.max(-halfHeight, Math.min(halfHeight, dy * cos - dx * sin));
  return { x: x + along * cos - across * sin, y: y + along * sin + across * cos };
}

/** The centre of the object at which the run ended, at that moment. If it has several places, the one nearest to her. */
function touchedAt(level: Level, run: Run): Place {
  const { final } = run;
  if (run.with === null) return final;
  const { kind, index } = run.with;
  if (kind === 'alien') {
    const aliens = new Float64Array(3 * level.aliens.length);
    run.trajectory.aliensAt(run.trajectory.duration, aliens);
    return { x: aliens[3 * index], y: aliens[3 * index + 1] };
  }
  const away = ({ x, y }: Place): number => Math.hypot(x - final.x, y - final.y);
  return placesIn(kind, thingsOf(level, kind)[index]).reduce((a, b) => (away(b) < away(a) ? b : a));
}

/** If the closest approach is less than this before the end of the run, s, her figure at the end serves for it. */
const AT_END = 0.25;

/** Draws the closest approach of a run: her box at that moment, and its distance from the rim of the black hole. */
export function drawGap(view: View, theme: Theme, level: Level, run: Run, time: number): string {
  const state = new Float64Array(STATE_SIZE);
  run.trajectory.at(time, state);
  const [x, y, , , cos, sin] = state;
  const { blackHole } = level;
  const box = boxOf(rulesOf(level));
  // The nearest point of her box, and the point of the rim that faces it.
  const near = nearestOfBox(box, { x, y, cos, sin }, blackHole);
  const far = Math.hypot(blackHole.x - near.x, blackHole.y - near.y) || 1;
  const rimX = blackHole.x - ((blackHole.x - near.x) * blackHole.radius) / far;
  const rimY = blackHole.y - ((blackHole.y - near.y) * blackHole.radius) / far;
  const gap = Math.max(0, boxCircleGap(box, blackHole.x - x, blackHole.y - y, cos, sin, blackHole.radius));
  const angle = num((Math.atan2(sin, cos) * 180) / Math.PI);
  const drawing = `<g transform="rotate(${angle})">${drawAstronaut(theme, theme.good, box)}</g>`;
  const figure = run.trajectory.duration - time < AT_END ? '' : place(view, 'nearest', 0, { x, y }, drawing);
  const [ax, ay, bx, by] = [view.x(near.x), view.y(near.y), view.x(rimX), view.y(rimY)];
  const text = `${gap.toFixed(1)} px`;
  const width = textWidth(text, 8) + 10;
  // Beside the line, on its upper side.
  const length = Math.hypot(bx - ax, by - ay) || 1;
  const side = bx >= ax ? 1 : -1;
  const tx = (ax + bx) / 2 + (side * (by - ay) * (width / 2 + 8)) / length;
  const ty = (ay + by) / 2 - (side * (bx - ax) * 16) / length;
  return (
    `${figure}<g data-kind="gap"><path d="M${num(ax)} ${num(ay)}L${num(bx)} ${num(by)}" stroke="${theme.halo}" stroke-width="5" stroke-opacity=".6"/>` +
    `<path d="M${num(ax)} ${num(ay)}L${num(bx)} ${num(by)}" stroke="${theme.good}" stroke-width="2" stroke-dasharray="5 3"/>` +
    `<circle cx="${num(ax)}" cy="${num(ay)}" r="3" fill="${theme.good}"/><circle cx="${num(bx)}" cy="${num(by)}" r="3" fill="${theme.good}"/>` +
    `<rect x="${num(tx - width / 2)}" y="${num(ty - 9)}" width="${num(width)}" height="16" rx="4" fill="${theme.halo}" fill-opacity=".8"/>` +
    `${drawText(text, tx, ty + 3, { size: 8, color: theme.good, anchor: 'middle', bold: true })}</g>`
  );
}
