import { eventRule, offerFrom, quietWithin, rimTime } from '../../events/index.ts';
import { distanceSquared, GOES_ON, type Motion, nearest, placeRock, RECORDS, relativeAt, SLOTS } from '../../motion/index.ts';
import { DISTANCE_ROUNDING, SURPLUS } from '../../tolerances.ts';
import type { Effect } from '../effect.ts';

const { START, COVER, HELD, BASE } = SLOTS;
const { ROCK } = RECORDS;

/** Of a squared distance; {@link rimTime} counts her as inside as far as that. */
const ROUNDING = 1e-12;

/** Room for the rounding of a time, and for what is at the same instant. */
const LATE = 1.001;

/** She leaves the range of the asteroid that kept her in range: another one takes over, or she is lost. */
const leaveRange = eventRule({
  name: 'range',
  ends: { outcome: 'lost', touches: null },
  always(m, from) {
    const { s, scene, path } = m;
    const cover = s[COVER];
    if (cover < 0) {
      offerFrom(m, from, leaveRange.kind, -1, 0, from, true);
      return;
    }
    const { range } = scene.level;
    const within = range - path.reach - SURPLUS;
    const o = m.rocks + ROCK * cover;
    const dx = (m.recoil ? s[o] : m.targetX[cover]) - path.x;
    const dy = (m.recoil ? s[o + 1] : m.targetY[cover]) - path.y;
    if (within > 0 && dx * dx + dy * dy < within * within) return;
    placeRock(m, cover);
    const time = rimTime(m, range, false, m.kappa, from, false);
    // out of it by more than rounding where a piece begins: a jump has brought her there
    const stands = time === from && isOutOfRange(m, cover, s[START] === 0 ? 1 : 1 + 1e-9);
    offerFrom(m, time, leaveRange.kind, cover, 0, from, stands);
  },
  latest(m) {
    const { s, ux, uy, px, py } = m;
    const cover = s[COVER];
    // an asteroid that she holds may follow her
    if (cover < 0 || (m.recoil && s[HELD] === 1)) return Number.POSITIVE_INFINITY;
    const drifts = m.recoil && cover !== s[BASE];
    const o = m.rocks + ROCK * cover;
    const vx = ux[1] + (drifts ? px[1] - s[o + 2] : 0);
    const vy = uy[1] + (drifts ? py[1] - s[o + 3] : 0);
    return (LATE * (Math.sqrt(distanceSquared(m, cover)) + m.scene.level.range)) / Math.sqrt(vx * vx + vy * vy);
  },
  alwaysQuiet(m, time) {
    const left = m.scene.level.range - Math.sqrt(distanceSquared(m, m.s[COVER])) - SURPLUS;
    return quietWithin(m, left, -m.path.speed, time);
  },
  fire(m, cover) {
    let other = nearest(m);
    if (other < 0 || other === cover || isOutOfRange(m, other, 1 - 4 * DISTANCE_ROUNDING)) other = enteredAtOnce(m, cover);
    if (other < 0) return 0;
    m.s[COVER] = other;
    return GOES_ON;
  },
});

/** An asteroid whose range she enters as she leaves that of `left`, or -1. */
function enteredAtOnce(m: Motion, left: number): number {
  const { toCircle } = m;
  for (let i = 0; i < m.scene.targets.count; i++) {
    if (i === left || isOutOfRange(m, i, 1 + ROUNDING)) continue;
    placeRock(m, i);
    relativeAt(m, 0);
    const speed = Math.sqrt(toCircle[2] * toCircle[2] + toCircle[3] * toCircle[3]);
    // along its rim by any rounding is not into it
    if (toCircle[0] * toCircle[2] + toCircle[1] * toCircle[3] < -DISTANCE_ROUNDING * speed * m.scene.level.range) return i;
  }
  return -1;
}

/** @param share - of the squared range */
function isOutOfRange(m: Motion, target: number, share: number): boolean {
  const { range } = m.scene.level;
  return distanceSquared(m, target) > range * range * share;
}

export const range: Effect = {
  name: 'range',
  summary: () => 'she is lost when she is farther than the range from every asteroid',
  calledFor: () => ({ called: true, because: 'every level has one' }),
  events: [leaveRange],
  layOut(m) {
    m.s[COVER] = nearest(m);
  },
};
