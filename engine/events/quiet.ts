import type { Circles } from '../indexed-circles.ts';
import { type Motion, SLOTS } from '../motion/index.ts';
import { SURPLUS } from '../tolerances.ts';
import { refresh } from './neighbourhood.ts';
import { safeStep } from './roots.ts';

const { BASE_X, BASE_Y, TARGET, AWAKE_COUNT } = SLOTS;

/** Factor by which a fixed step may overestimate a force. */
const FIXED_STEP_ROOM = 1.05;

/** Longest time that is examined, s. */
const LONGEST = 4;

/**
 * Quiet time: for how long no event can happen, s, in a flow without a steady force. It is the shortest first step towards any
 * guard. As forces change at events only, the one that acts now bounds her acceleration. 0 while a chaser chases her.
 */
export function quietTime(m: Motion): number {
  const { s, near, path, parts, ux, uy, integrator } = m;
  const { rate } = m.scene.accuracy;
  if (s[AWAKE_COUNT] > 0) return 0;
  const x = s[BASE_X] + ux[0];
  const y = s[BASE_Y] + uy[0];
  const strongest = FIXED_STEP_ROOM * Math.abs(m.flow.alpha);
  path.strongest = strongest;
  path.lead = integrator.kicksFirst && rate !== null ? strongest / rate : 0;
  const v = Math.sqrt(ux[1] * ux[1] + uy[1] * uy[1]) + path.lead;
  path.x = x;
  path.y = y;
  path.vx = ux[1];
  path.vy = uy[1];
  path.speed = v;
  const reach = (v + strongest * LONGEST) * LONGEST;
  // the list must hold for the whole stretch; a shorter stretch is better than making the list anew too often
  if (!near.covers(x, y, Math.min(reach, 16), s[TARGET])) refresh(m, x, y, 64);
  const gone = Math.sqrt((x - near.x) * (x - near.x) + (y - near.y) * (y - near.y));
  let time = Math.min(LONGEST, safeStep(Math.min(near.skin - gone, 1e6), -v, strongest));
  for (let n = 0; n < near.count && time > 0; n++) {
    if (near.slack[n] > gone + (v + strongest * time) * time) continue;
    const rule = parts.byKind[near.kind[n]];
    time = rule.quiet === null ? 0 : rule.quiet(m, near.index[n], time);
  }
  for (const rule of parts.alwaysQuiet) time = rule.alwaysQuiet === null ? 0 : rule.alwaysQuiet(m, time);
  return time;
}

/** For how long, at most `time` s, her centre stays outside a circle. Places are relative to the origin, px. */
export function quietOutside(m: Motion, cx: number, cy: number, r: number, time: number): number {
  const { path } = m;
  const dx = path.x - cx;
  const dy = path.y - cy;
  const d = Math.sqrt(dx * dx + dy * dy);
  // the distance from a point is convex
  return d > r ? Math.min(time, safeStep(d - r, (dx * path.vx + dy * path.vy) / d - path.lead, path.strongest)) : 0;
}

/**
 * For how long, at most `time` s, her centre cannot reach a place or cross a rim that is `gap` px away now.
 * @param slope - least rate of change of the gap now, px/s; minus her speed if nothing more is known
 */
export function quietWithin(m: Motion, gap: number, slope: number, time: number): number {
  return gap > 0 ? Math.min(time, safeStep(gap, slope, m.path.strongest)) : 0;
}

/**
 * For how long, at most `time` s, her centre cannot cross the rim of circle `i`, whose place is in px in the level.
 * @param inside - the side on which she counts; at the rim, the rounded distance does not tell
 */
export function quietAtRim(m: Motion, { x, y, r }: Circles, i: number, inside: boolean, time: number): number {
  const { path } = m;
  const dx = path.x + m.originX - x[i];
  const dy = path.y + m.originY - y[i];
  const d = Math.sqrt(dx * dx + dy * dy);
  const gap = (inside ? r[i] - d : d - r[i]) - SURPLUS;
  return quietWithin(m, gap, inside ? -path.speed : (dx * path.vx + dy * path.vy) / d - path.lead, time);
}

/** Objects farther away than this are not examined, px. */
const FARTHEST = 150;

/** Whether nothing but the pull of her target can matter before she is `far` px away and asteroids have moved by `rocks` px. */
export function isClear(m: Motion, far: number, rocks: number): boolean {
  const { s, near, parts, ux, uy } = m;
  if (s[AWAKE_COUNT] > 0 || far + rocks > FARTHEST) return false;
  const px = s[BASE_X] + ux[0];
  const py = s[BASE_Y] + uy[0];
  const reach = far + rocks;
  if (m.recoil || !near.covers(px, py, reach, s[TARGET])) refresh(m, px, py, reach);
  const gone = Math.sqrt((px - near.x) * (px - near.x) + (py - near.y) * (py - near.y)) + reach;
  for (let i = 0; i < near.count; i++) {
    const { isOver } = parts.byKind[near.kind[i]];
    if (isOver?.(m, near.index[i])) continue;
    if (near.slack[i] <= gone) return false;
  }
  return true;
}
