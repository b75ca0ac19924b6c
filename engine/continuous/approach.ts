import type { ClearanceTracker } from '../clearance.ts';
import { alienTravel, gapAt, ownTravel, rockTravel, sweptTime } from '../events/index.ts';
import {
  ALERTNESS,
  type Motion,
  placeAlien,
  placeAt,
  placeCircle,
  placeRock,
  RECORDS,
  relativeAt,
  SERIES,
  SLOTS,
} from '../motion/index.ts';
import type { BodyKind } from '../simulation.ts';

const { BASE_X, BASE_Y, NEXT } = SLOTS;
const { CHASER } = RECORDS;
const { GONE } = ALERTNESS;

/** The clearance is attained, and she is never nearer by more than this, px. */
const CLEARANCE_ERROR = 1e-6;

/**
 * The search for the lowest point of a dip ends at this time difference, s. About the lowest point the gap changes with its
 * square.
 */
const FINEST = 1e-8;

/**
 * Finds out whether she comes nearer to a hazard on the motion's current piece than `tracker` knows. It marches past each
 * hazard as if that were larger by the known clearance minus CLEARANCE_ERROR, so nothing nearer is missed. Where she touches
 * the enlarged hazard she comes nearer, and the lowest point of that dip becomes the known clearance.
 * @param start - when the piece begins, s
 * @param length - how long she is on it, s
 */
export function approachHazards(m: Motion, start: number, length: number, tracker: ClearanceTracker): void {
  const { s, her, base, toCircle, scene } = m;
  const { novae, targets, coldCount, aliens } = scene;
  // distances at one time cost less than marches
  const standing = novae.spatial === null ? novae.count : 0;
  m.budget.look(1 + ((standing + targets.count - coldCount + aliens.count) >> 3));
  const next = s[NEXT];
  s[NEXT] = Math.min(next, length);
  placeAt(m, 0);
  const x = m.originX + s[BASE_X] + her[0];
  const y = m.originY + s[BASE_Y] + her[1];
  const vx = her[2] + (m.recoil ? base[2] : 0);
  const vy = her[3] + (m.recoil ? base[3] : 0);
  const travel = ownTravel(m, Math.sqrt(vx * vx + vy * vy), length);
  const within = tracker.least + travel + m.box.halfDiagonal + 1e-6;
  const consider = (kind: BodyKind, i: number, r: number, pull: number, moves: number) => {
    relativeAt(m, 0);
    const far = Math.sqrt(toCircle[0] * toCircle[0] + toCircle[1] * toCircle[1]) - r - m.box.halfDiagonal - travel - moves;
    if (far < tracker.least) approach(m, start, length, tracker, kind, i, r, pull);
  };
  const nova = (i: number) => {
    const dx = novae.x[i] - x;
    const dy = novae.y[i] - y;
    const near = within + novae.r[i];
    if (dx * dx + dy * dy > near * near) return;
    placeCircle(m, novae.x[i], novae.y[i], m.originX, m.originY);
    consider('nova', novae.index[i], novae.r[i], 0, 0);
  };
  if (novae.spatial !== null && within < Number.POSITIVE_INFINITY) for (const i of novae.spatial.around(x, y, within)) nova(i);
  else for (let i = 0; i < novae.count; i++) nova(i);
  for (let i = coldCount; i < targets.count; i++) {
    placeRock(m, i);
    consider('asteroid', targets.index[i], targets.r[i], m.kappa, rockTravel(m, i, length));
  }
  for (let i = 0; i < aliens.count; i++) {
    if (s[m.chasers + CHASER * i + 4] === GONE) continue;
    placeAlien(m, i);
    consider(
      'alien',
      i,
      aliens.r[i],
      m.circleMotion === SERIES ? m.rules.alienPull : 0,
      alienTravel(m, i, m.rules.alienPull, length),
    );
  }
  s[NEXT] = next;
}

/** The same for one hazard, the placed circle. */
function approach(
  m: Motion,
  start: number,
  length: number,
  tracker: ClearanceTracker,
  kind: BodyKind,
  index: number,
  r: number,
  pull: number,
): void {
  tracker.take(start, gapAt(m, 0, r), kind, index);
  for (let t = 0; length > 0; ) {
    // she cannot come nearer than its centre
    const reach = r + tracker.least - CLEARANCE_ERROR;
    if (reach <= 0) return;
    t = sweptTime(m, reach, pull, t);
    if (t < 0 || t > length) return;
    const bottom = bottomOfDip(m, r, t, length);
    tracker.take(start + bottom, gapAt(m, bottom, r), kind, index);
  }
}

/** When a dip that begins at `t` is lowest, s: steps on while it goes down, then golden-section search. */
function bottomOfDip(m: Motion, r: number, t: number, length: number): number {
  let a = t;
  let b = t;
  let gap = gapAt(m, t, r);
  for (let h = FINEST; b < length; h *= 2) {
    const further = Math.min(length, b + h);
    const there = gapAt(m, further, r);
    if (there >= gap) {
      b = further;
      break;
    }
    a = Math.max(t, b - h);
    b = further;
    gap = there;
  }
  const share = (3 - Math.sqrt(5)) / 2;
  let c = a + share * (b - a);
  let d = b - share * (b - a);
  let atC = gapAt(m, c, r);
  let atD = gapAt(m, d, r);
  while (b - a > FINEST) {
    if (atC < atD) {
      b = d;
      d = c;
      atD = atC;
      c = a + share * (b - a);
      atC = gapAt(m, c, r);
    } else {
      a = c;
      c = d;
      atC = atD;
      d = b - share * (b - a);
      atD = gapAt(m, d, r);
    }
  }
  // it may go down to the very end of the piece
  return gapAt(m, b, r) < Math.min(atC, atD) ? b : atC < atD ? c : d;
}
