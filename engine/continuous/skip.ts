import { ALIEN_SIGHT, GUN_PULL, HALF_DIAGONAL, SPEED_LIMIT } from '../constants.ts';
import { COAST, LINEAR, SLIDE } from './flow.ts';
import { switchGuard } from './guards/target-switch.ts';
import { safeStep } from './march.ts';
import type { Motion } from './motion.ts';
import { distanceSquared } from './nearest.ts';
import { refresh } from './neighbourhood.ts';
import { driftsBy, isTiny, untilTick } from './orbits.ts';
import { directionAt } from './places.ts';
import { EVENTS, MEETINGS, RECORDS, SLOTS } from './state.ts';

const { START, TARGET, COVER, BASE_X, BASE_Y, KIND, COS, SIN, DEGREE, AWAKE_COUNT, CROSSED, CROSSED_BEFORE, MEETS } = SLOTS;
const { MINERAL, NOVA, HOT, ALIEN_TOUCH, HOLE, ENTER, WAKE } = EVENTS;
const { CHASER } = RECORDS;
const { NOT } = MEETINGS;

/** Bound on any acceleration of hers, px/s2, with room for what a fixed step makes of it. */
const STRONGEST = 1.05 * GUN_PULL;

/**
 * She swings to and fro on a line through the centre, faster than the ticks: after two crossings everything is as it
 * was but the time, so whole periods are skipped, up to the next tick.
 */
export function skipPeriods(m: Motion): void {
  const { s } = m;
  const period = s[CROSSED] > 0 ? s[START] - s[CROSSED_BEFORE] : 0;
  if (s[CROSSED_BEFORE] > 0 && period > 0 && s[AWAKE_COUNT] === 0) {
    const skipped = Math.floor(untilTick(s[START]) / period) - 1;
    if (skipped > 0 && (!m.recoil || driftsBy(m, skipped * period, period))) {
      s[START] += skipped * period;
      m.modeSeconds[m.mode] += skipped * period;
      s[CROSSED] += skipped * period;
    }
  }
  s[CROSSED_BEFORE] = s[CROSSED];
  s[CROSSED] = s[START];
}

/**
 * Makes the fixed steps during which nothing can happen, up to `until`, without looking for events: those that she
 * needs at least to cover the distance to the nearest guard. Gives the bits that piece after piece would.
 */
export function skipQuietSteps(m: Motion, until: number): void {
  const { s, ux, uy, flow, integrator, work } = m;
  const { rate } = m.scene.accuracy;
  if (integrator.glide === null || rate === null || m.recoil || s[KIND] === COAST || s[KIND] === SLIDE) return;
  // orbits may be skipped at the end of any piece: none is to be glided over
  if (isTiny(m, 4)) return;
  const v = Math.sqrt(ux[1] * ux[1] + uy[1] * uy[1]);
  if (v > SPEED_LIMIT / 2) return;
  const end = Math.min(until, s[START] + quietTime(m));
  const from = s[START];
  m.steps[0] = 0;
  const start = integrator.glide(flow, ux, uy, from, end, rate, m.steps);
  const steps = m.steps[0];
  if (steps === 0) return;
  s[START] = start;
  s[DEGREE] = 1;
  directionAt(m, 0);
  s[COS] = m.e[8];
  s[SIN] = m.e[9];
  m.modeSeconds[m.mode] += start - from;
  work.pieces += steps;
  work.forceEvaluations += steps * integrator.evaluations;
}

/**
 * For how long no guard can fire whatever the flow does, s: first strides of the march, with bounds that hold for any
 * piece. 0 while an alien is awake.
 */
function quietTime(m: Motion): number {
  const { s, scene, near, ux, uy } = m;
  if (s[AWAKE_COUNT] > 0) return 0;
  const { novae, targets, minerals, repulsors, aliens, level } = scene;
  const x = s[BASE_X] + ux[0];
  const y = s[BASE_Y] + uy[0];
  const vx = ux[1];
  const vy = uy[1];
  const v = Math.sqrt(vx * vx + vy * vy);
  const longest = 4;
  const reach = (v + STRONGEST * longest) * longest;
  // the list must hold for the whole stretch; a shorter one is better than making it anew too often
  if (!near.covers(x, y, Math.min(reach, 16), s[TARGET])) refresh(m, x, y, 64);
  const gone = Math.sqrt((x - near.x) * (x - near.x) + (y - near.y) * (y - near.y));
  let time = Math.min(longest, safeStep(Math.min(near.skin - gone, 1e6), -v, STRONGEST));
  const outOf = (cx: number, cy: number, r: number) => {
    const dx = x - cx;
    const dy = y - cy;
    const d = Math.sqrt(dx * dx + dy * dy);
    // the distance from a point is convex
    time = d > r ? Math.min(time, safeStep(d - r, (dx * vx + dy * vy) / d, STRONGEST)) : 0;
  };
  for (let n = 0; n < near.count && time > 0; n++) {
    if (near.slack[n] > gone + (v + STRONGEST * time) * time) continue;
    const i = near.index[n];
    const margin = HALF_DIAGONAL + 1e-6;
    switch (near.kind[n]) {
      case NOVA:
        outOf(novae.x[i] - m.originX, novae.y[i] - m.originY, novae.r[i] + margin);
        break;
      case HOT:
        outOf(m.targetX[i], m.targetY[i], targets.r[i] + margin);
        break;
      case HOLE:
        outOf(level.blackHole.x - m.originX, level.blackHole.y - m.originY, level.blackHole.radius + margin);
        break;
      case MINERAL:
        if (s[m.minerals + i] === 0) outOf(minerals.x[i] - m.originX, minerals.y[i] - m.originY, minerals.r[i] + margin);
        break;
      case ENTER: {
        const dx = x + m.originX - repulsors.x[i];
        const dy = y + m.originY - repulsors.y[i];
        const d = Math.sqrt(dx * dx + dy * dy);
        // at the rim the flag says which side counts, not the rounded distance
        const inside = s[m.inside + i] === 1;
        const gap = (inside ? repulsors.r[i] - d : d - repulsors.r[i]) - 1e-6;
        time = gap > 0 ? Math.min(time, safeStep(gap, inside ? -v : (dx * vx + dy * vy) / d, STRONGEST)) : 0;
        break;
      }
      case WAKE:
      case ALIEN_TOUCH: {
        const o = m.chasers + CHASER * i;
        outOf(s[o], s[o + 1], near.kind[n] === WAKE ? ALIEN_SIGHT + 1e-6 : aliens.r[i] + margin);
        break;
      }
      default: {
        const g = switchGuard(m, i, 0) - 1e-6;
        const mx = m.targetX[i] - m.targetX[s[TARGET]];
        const my = m.targetY[i] - m.targetY[s[TARGET]];
        const apart = Math.sqrt(mx * mx + my * my);
        time = g > 0 ? Math.min(time, safeStep(g, m.e[9], 2 * apart * STRONGEST)) : 0;
      }
    }
  }
  const left = level.range - Math.sqrt(distanceSquared(m, s[COVER])) - 1e-6;
  time = left > 0 ? Math.min(time, safeStep(left, -v, STRONGEST)) : 0;
  if (s[KIND] === LINEAR) time = Math.min(time, safeStep(Math.sqrt(ux[0] * ux[0] + uy[0] * uy[0]), -v, STRONGEST));
  if (s[MEETS] !== NOT) time = Math.min(time, safeStep(Math.sqrt(distanceSquared(m, s[TARGET])), -v, STRONGEST));
  return time;
}
