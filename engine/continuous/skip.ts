import { quietTime } from '../events/index.ts';
import { COAST, directionAt, type Motion, SLIDE, SLOTS } from '../motion/index.ts';

const { START, KIND, COS, SIN, DEGREE } = SLOTS;

/**
 * Makes the fixed steps up to `until` during which nothing can happen, without looking for events: the number of steps she
 * needs at least to reach the nearest guard. The bits are the same as piece after piece.
 */
export function skipQuietSteps(m: Motion, until: number): void {
  const { s, ux, uy, flow, integrator, work } = m;
  const { rate } = m.scene.accuracy;
  if (integrator.glide === null || rate === null || m.recoil || s[KIND] === COAST || s[KIND] === SLIDE || flow.isSteady) return;
  // orbits may be skipped at the end of any piece, so no piece may be left out
  if (m.parts.mayRepeat.some((mayRepeat) => mayRepeat(m))) return;
  const end = Math.min(until, s[START] + quietTime(m));
  const from = s[START];
  m.steps[0] = 0;
  const start = integrator.glide(flow, ux, uy, from, end, rate, m.steps);
  const steps = m.steps[0];
  if (steps === 0) return;
  s[START] = start;
  s[DEGREE] = 1;
  directionAt(m, 0);
  s[COS] = m.facing[0];
  s[SIN] = m.facing[1];
  m.modeSeconds[m.mode] += start - from;
  work.pieces += steps;
  work.forceEvaluations += steps * integrator.evaluations;
}
