import { boxCircleGap, boxOf, type Run, STATE_SIZE } from '../engine/index.ts';
import { type Level, rulesOf } from '../schema/index.ts';
import { drawAstronaut } from './kinds/index.ts';
import { place } from './place.ts';
import { drawText, textWidth } from './text.ts';
import type { Theme } from './theme.ts';
import type { View } from './view.ts';
import { num } from './xml.ts';

/** If the closest approach is less than this before the end of the run, s, her figure at the end serves for it. */
const AT_END = 0.25;

/** Draws the closest approach of a run: her box at that moment, and its distance from the rim of the black hole. */
export function drawGap(view: View, theme: Theme, level: Level, run: Run, time: number): string {
  const state = new Float64Array(STATE_SIZE);
  run.trajectory.at(time, state);
  const [x, y, , , cos, sin] = state;
  const { blackHole } = level;
  const box = boxOf(rulesOf(level));
  const dx = blackHole.x - x;
  const dy = blackHole.y - y;
  // The nearest point of her box, and the point of the rim that faces it.
  const along = Math.max(-box.halfWidth, Math.min(box.halfWidth, dx * cos + dy * sin));
  const across = Math.max(-box.halfHeight, Math.min(box.halfHeight, dy * cos - dx * sin));
  const nearX = x + along * cos - across * sin;
  const nearY = y + along * sin + across * cos;
  const far = Math.hypot(blackHole.x - nearX, blackHole.y - nearY) || 1;
  const rimX = blackHole.x - ((blackHole.x - nearX) * blackHole.radius) / far;
  const rimY = blackHole.y - ((blackHole.y - nearY) * blackHole.radius) / far;
  const gap = Math.max(0, boxCircleGap(box, dx, dy, cos, sin, blackHole.radius));
  const angle = num((Math.atan2(sin, cos) * 180) / Math.PI);
  const drawing = `<g transform="rotate(${angle})">${drawAstronaut(theme, theme.good, box)}</g>`;
  const figure = run.trajectory.duration - time < AT_END ? '' : place(view, 'nearest', 0, { x, y }, drawing);
  const [ax, ay, bx, by] = [view.x(nearX), view.y(nearY), view.x(rimX), view.y(rimY)];
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
