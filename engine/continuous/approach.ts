import type { ClearanceTracker, HazardList } from '../clearance.ts';
import { chaserTravel, gapAt, ownTravel, rockTravel, sweptTime } from '../events/index.ts';
import {
  ALERTNESS,
  type Motion,
  placeAt,
  placeChaser,
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
  const { s, her, base, toCircle } = m;
  const { lists } = tracker;
  // distances at one time cost less than marches; what an index finds is not examined one by one
  let examined = 0;
  for (const list of lists) if (!isFoundByIndex(list)) examined += list.circles.count - list.first;
  m.budget.look(1 + (examined >> 3));
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
  for (const list of lists) {
    const { kind, circles, first, movedBy } = list;
    const standing = (i: number) => {
      const dx = circles.x[i] - x;
      const dy = circles.y[i] - y;
      const near = within + circles.r[i];
      if (dx * dx + dy * dy > near * near) return;
      placeCircle(m, circles.x[i], circles.y[i], m.originX, m.originY);
      consider(kind, circles.index[i], circles.r[i], 0, 0);
    };
    if (isFoundByIndex(list) && within < Number.POSITIVE_INFINITY) {
      for (const i of circles.spatial?.around(x, y, within) ?? []) standing(i);
      continue;
    }
    for (let i = first; i < circles.count; i++) {
      if (movedBy === 'nothing') {
        standing(i);
      } else if (movedBy === 'recoil') {
        placeRock(m, i);
        consider(kind, circles.index[i], circles.r[i], m.kappa, rockTravel(m, i, length));
      } else if (s[m.chasers + CHASER * i + 4] !== GONE) {
        placeChaser(m, i);
        const pull = m.circleMotion === SERIES ? m.chaserPull : 0;
        consider(kind, circles.index[i], circles.r[i], pull, chaserTravel(m, i, m.chaserPull, length));
      }
    }
  }
  s[NEXT] = next;
}

/** What stands still is found by its index, if it has one. */
const isFoundByIndex = ({ circles, movedBy }: HazardList): boolean => movedBy === 'nothing' && circles.spatial !== null;

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
