import { boxOf, type Run } from '../engine/index.ts';
import { type Level, placesIn, rulesOf } from '../schema/index.ts';
import type { Theme } from './theme.ts';
import { thingsOf } from './things.ts';
import type { View } from './view.ts';
import { num } from './xml.ts';

const CROSS = 'M-7-7L7 7M-7 7L7-7';

/**
 * Marks the place where the run ended: a ring at the black hole, a cross in a ring at a hazard, a broken ring where she was
 * lost.
 */
export function drawContact(view: View, theme: Theme, level: Level, run: Run): string {
  const { final, outcome } = run;
  if (outcome === 'timeout') return '';
  const at = outcome === 'lost' ? final : touchOf(level, run);
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

/** The point of her box nearest to what she touched: its centre, clamped to the box in the box's own axes. */
function touchOf(level: Level, run: Run): { x: number; y: number } {
  const { x, y, cos, sin } = run.final;
  const touched = touchedAt(level, run);
  const dx = touched.x - x;
  const dy = touched.y - y;
  const { halfWidth, halfHeight } = boxOf(rulesOf(level));
  const along = Math.max(-halfWidth, Math.min(halfWidth, dx * cos + dy * sin));
  const across = Math.max(-halfHeight, Math.min(halfHeight, dy * cos - dx * sin));
  return { x: x + along * cos - across * sin, y: y + along * sin + across * cos };
}

/** The centre of the object at which the run ended, at that moment. If it has several places, the one nearest to her. */
function touchedAt(level: Level, run: Run): { readonly x: number; readonly y: number } {
  const { final } = run;
  if (run.with === null) return final;
  const { kind, index } = run.with;
  if (kind === 'alien') {
    const aliens = new Float64Array(3 * level.aliens.length);
    run.trajectory.aliensAt(run.trajectory.duration, aliens);
    return { x: aliens[3 * index], y: aliens[3 * index + 1] };
  }
  const away = ({ x, y }: { readonly x: number; readonly y: number }): number => Math.hypot(x - final.x, y - final.y);
  return placesIn(kind, thingsOf(level, kind)[index]).reduce((a, b) => (away(b) < away(a) ? b : a));
}
