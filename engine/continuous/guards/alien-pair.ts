import { ALIEN_PULL } from '../../constants.ts';
import { offer } from '../first-event.ts';
import { safeStep, smallestStride } from '../march.ts';
import type { Motion } from '../motion.ts';
import { alienTravel } from '../neighbourhood.ts';
import { alienPlaceAt } from '../places.ts';
import { ALERTNESS, EVENTS, RECORDS, SLOTS } from '../state.ts';

const { LENGTH_H } = SLOTS;
const { PAIR } = EVENTS;
const { CHASER } = RECORDS;
const { GONE } = ALERTNESS;

/** Two aliens that come to touch before the piece ends explode. @param from s from its start */
export function considerPair(m: Motion, i: number, j: number, from: number): void {
  const { s, scene, work } = m;
  const a = m.chasers + CHASER * i;
  const b = m.chasers + CHASER * j;
  if (s[b + 4] === GONE) return;
  const reach = scene.aliens.r[i] + scene.aliens.r[j];
  const d = Math.sqrt((s[a] - s[b]) * (s[a] - s[b]) + (s[a + 1] - s[b + 1]) * (s[a + 1] - s[b + 1]));
  const h = s[LENGTH_H];
  if (d - alienTravel(m, i, h) - alienTravel(m, j, h) > reach + 1e-6) return;
  work.guards++;
  const e = m.e;
  const horizon = Math.min(m.horizon, h);
  let t = from;
  let small = smallestStride(h);
  for (let n = 0; ; n++) {
    m.budget.look(1);
    alienPlaceAt(m, i, t, 0);
    alienPlaceAt(m, j, t, 4);
    const dx = e[0] - e[4];
    const dy = e[1] - e[5];
    const vx = e[2] - e[6];
    const vy = e[3] - e[7];
    const g = dx * dx + dy * dy - reach * reach;
    if (g < 0) {
      offer(m, t, PAIR, i, j);
      return;
    }
    // (d^2)'' = 2 v^2 + 2 d a >= -2 |d| |a| while d stays below `far`
    const slope = 2 * (dx * vx + dy * vy);
    const far = Math.sqrt(dx * dx + dy * dy) + (Math.sqrt(vx * vx + vy * vy) + 2 * ALIEN_PULL * h) * h;
    const step = safeStep(g, slope, 4 * far * ALIEN_PULL);
    if (!(t + step < horizon)) return;
    if (n > 400) small *= 2;
    t = Math.min(horizon, t + Math.max(step, small));
  }
}
