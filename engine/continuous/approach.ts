import { type ClearanceTracker, type HazardList, hazardCount } from '../clearance.ts';
import { chaserTravel, gapAt, ownTravel, rockTravel, sweptTime } from '../events/index.ts';
import { type IndexedCircles, NO_CIRCLES } from '../indexed-circles.ts';
import {
  ALERTNESS,
  type Motion,
  type PackedPieces,
  placeAt,
  placeChaser,
  placeCircle,
  placeRock,
  RECORDS,
  relativeAt,
  SERIES,
  SLOTS,
} from '../motion/index.ts';
import type { Scene } from '../scene.ts';
import type { BodyKind } from '../simulation.ts';
import type { WorkBudget } from '../work-budget.ts';

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

/** Hazards of which it is mostly plain that they are far: recoil moves none of them, and an index finds none. */
export class FarHazards {
  /** A place, px in the level, and a lower bound of its distance to the edge of the nearest one that stands still. */
  private x = 0;
  private y = 0;
  private distance = Number.NEGATIVE_INFINITY;
  private readonly still: readonly HazardList[];
  private readonly chasers: IndexedCircles;
  /** What the search on a piece spends at least. */
  private readonly looks: number;
  /** Place, velocity and bound of the acceleration, as {@link PackedPieces.startOf} writes them. */
  private readonly start = new Float64Array(5);
  /** As {@link PackedPieces.chordOf} writes it. */
  private readonly chord = new Float64Array(3);

  private constructor(
    private readonly scene: Scene,
    private readonly pieces: PackedPieces,
    lists: readonly HazardList[],
  ) {
    this.still = lists.filter(({ movedBy }) => movedBy !== 'chase');
    this.chasers = lists.find(({ movedBy }) => movedBy === 'chase')?.circles ?? NO_CIRCLES;
    this.looks = 1 + (hazardCount(lists) >> 3) + hazardCount(lists.filter(({ movedBy }) => movedBy === 'recoil'));
  }

  /** @returns null where recoil may move some hazard, or there are many */
  static of(scene: Scene, pieces: PackedPieces, lists: readonly HazardList[]): FarHazards | null {
    if (scene.level.recoil) return null;
    const some = lists.filter(({ circles, first }) => circles.count > first);
    return some.every(({ circles }) => circles.spatial === null) ? new FarHazards(scene, pieces, some) : null;
  }

  /** The gap to one that stands still, where a piece begins, is less than this, px: the box has a disc in it. */
  gapAtStart(piece: number): number {
    const { start, still } = this;
    const { halfWidth, halfHeight } = this.scene.box;
    this.pieces.startOf(piece, start);
    const { x, y } = this.scene.level.astronaut;
    return Math.max(0, distanceTo(still, x + start[0], y + start[1], 0, 0) - Math.min(halfWidth, halfHeight)) + MARGIN;
  }

  /**
   * Whether {@link approachHazards} would find nothing nearer than `least` px on a piece. If so, the budget is as if it had looked.
   * @param motion - the state has the chasers as they are when the piece begins; null if there are none
   */
  areOn(piece: number, length: number, least: number, budget: WorkBudget, motion: Motion | null): boolean {
    const { start, scene, pieces } = this;
    pieces.startOf(piece, start);
    const x = scene.level.astronaut.x + start[0];
    const y = scene.level.astronaut.y + start[1];
    const speed = Math.sqrt(start[2] * start[2] + start[3] * start[3]);
    // as `ownTravel` has it without recoil; twice the margin with which the search leaves hazards out
    const reach = least + (speed + (start[4] / 2) * length) * length + scene.box.halfDiagonal + 2e-6;
    const dx = x - this.x;
    const dy = y - this.y;
    if (!(this.distance - Math.sqrt(dx * dx + dy * dy) > reach) && !this.areBesideWay(piece, length, least, reach)) return false;
    let looks = 0;
    for (let i = 0; motion !== null && i < this.chasers.count; i++) {
      const { s } = motion;
      const o = motion.chasers + CHASER * i;
      if (s[o + 4] === GONE) continue;
      const far = Math.sqrt((s[o] - start[0]) * (s[o] - start[0]) + (s[o + 1] - start[1]) * (s[o + 1] - start[1]));
      if (!(far - this.chasers.r[i] - chaserTravel(motion, i, motion.chaserPull, length) > reach)) return false;
      looks++;
    }
    budget.look(this.looks + looks);
    return true;
  }

  /** Whether those that stand still are far from the whole way of a piece, which `start` has been read of. */
  private areBesideWay(piece: number, length: number, least: number, reach: number): boolean {
    const { start, chord, scene, still } = this;
    const { x, y } = scene.level.astronaut;
    this.x = x + start[0];
    this.y = y + start[1];
    this.distance = distanceTo(still, this.x, this.y, 0, 0);
    if (this.distance > reach) return true;
    if (!(this.distance > least + scene.box.halfDiagonal + MARGIN)) return false;
    this.pieces.chordOf(piece, length, chord);
    const away = distanceTo(still, this.x, this.y, chord[0] - start[0], chord[1] - start[1]);
    return away > least + chord[2] + scene.box.halfDiagonal + MARGIN;
  }
}

/** Far above what rounding, and the line that she is kept on, may change of a place, px. */
const MARGIN = 1e-3;

/**
 * Distance of a straight way to the edge of the nearest hazard, where all of them stand still.
 * @param x - where it begins, px in the level
 * @param wayX - how far it leads, px
 */
function distanceTo(lists: readonly HazardList[], x: number, y: number, wayX: number, wayY: number): number {
  const square = wayX * wayX + wayY * wayY;
  let least = Number.POSITIVE_INFINITY;
  for (const { circles, first } of lists) {
    for (let i = first; i < circles.count; i++) {
      const dx = circles.x[i] - x;
      const dy = circles.y[i] - y;
      const share = square > 0 ? Math.min(1, Math.max(0, (dx * wayX + dy * wayY) / square)) : 0;
      const offX = dx - share * wayX;
      const offY = dy - share * wayY;
      const d = Math.sqrt(offX * offX + offY * offY) - circles.r[i];
      if (!(d >= least)) least = d;
    }
  }
  return least;
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
