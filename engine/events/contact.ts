import { type Box, boxCircleGap } from '../contact.ts';
import { LINES, lookAt, type Motion, relativeAt, SLOTS, TURNS } from '../motion/index.ts';
import { CUBIC_BENDS, DISTANCE_ROUNDING, FLOOR } from '../tolerances.ts';
import { fineGap } from './fine-gap.ts';
import { grazeStep } from './graze.ts';
import { lookNext, overlapBetween, PATIENCE, safeStep, smallestStride } from './roots.ts';
import { offerFrom } from './rule.ts';

const { START, TURN, COS, SIN, LIMIT_X, LIMIT_Y, LINE, NEXT, LENGTH_H, ACCELERATION } = SLOTS;
const { TURN_NOT, TURN_TO_BASE, TURN_TO_TARGET } = TURNS;

/** A gap below this many times its rounding error is computed in twice the digits. */
const UNCERTAIN = 8;

/** Direction of the box when its gap was last computed: cos, sin. */
const look = new Float64Array(2);

/**
 * Offers the contact with the placed circle. At its beginning it can be an overlap that stands, or an exact touch, which is no
 * contact yet. The level's numbers are not rounded, so at the start the least overlap counts; later it must exceed the error of
 * the path.
 * @param r - radius, px
 * @param pull - bound of the circle's own acceleration, px/s²
 * @param kind - the kind of event
 * @param a - index of the object
 * @param from - where to begin, s after the start of the piece
 */
export function offerContact(m: Motion, r: number, pull: number, kind: number, a: number, from: number): void {
  const time = contactTime(m, r, pull, from);
  const stands = time === from && gapAt(m, time, r) < (m.s[START] === 0 ? 0 : -FLOOR);
  offerFrom(m, time, kind, a, 0, from, stands);
}

/**
 * First time at which a contact with the placed circle counts: when it happens, or at the frame that sees it.
 * @param r - radius, px
 * @param pull - bound of the circle's own acceleration, px/s²
 * @param from - where to begin, s after the start of the piece
 * @returns s after the start of the piece; -1 if there is none before the piece ends
 */
function contactTime(m: Motion, r: number, pull: number, from: number): number {
  const { s, frameRate } = m;
  let t = sweptTime(m, r, pull, from);
  if (frameRate === 0) return t;
  // a frame sees a contact within an overlap; one that is over before the next frame is missed, as in games
  let frame = Number.NEGATIVE_INFINITY;
  while (t >= 0) {
    frame = Math.max(frame + 1, Math.ceil((s[START] + t) * frameRate - 1e-7));
    t = Math.max(0, frame / frameRate - s[START]);
    if (t > Math.min(m.horizon, s[LENGTH_H])) return -1;
    if (gapAt(m, t, r) < 0) return t;
    t = sweptTime(m, r, pull, t);
  }
  return -1;
}

/**
 * First time in [from, horizon] at which her box overlaps the placed circle, or -1. It is found by a march of safe steps
 * (conservative advancement), which can overlook only an overlap of less than FLOOR = 1e-12 px, however large the circle and
 * however fast she moves and turns. After the start such an overlap is none, since the rounding of her path may be as large.
 *
 * Two lower bounds of the gap ahead are used, each proved here; the longer step is taken. Let the present be time 0, D the
 * circle's centre minus hers, R(t) the rotation of the box, q the point of the box nearest to D in the box's frame, n the unit
 * vector from q to D in that frame, N = R(0) n the same vector in the world, and g the present gap.
 *
 * 1. In the box's frame the circle's centre is l = R^T D. The distance from a convex body is a convex function with gradient n,
 *   so gap(t) >= g + n.(l(t) - l(0)). l' = R^T D' - w J l and l'' = R^T D'' - 2 w J R^T D' - w' J l - w^2 l, where J turns by
 *   90 degrees and w is the angular velocity of the box. So the slope falls by at most k = |D''| + 2 |w| |D'| + (|w'| + w^2)
 *   |D|. This bound is tight where a side is nearest, for any radius.
 * 2. The half plane N.x >= N.D(t) - r contains the circle. The box is the convex hull of its corners b, so gap(t) >= min over b
 *   of N.D(t) - r - N.R(t) b. The second derivative of N.R(t) b is at most (w^2 + |w'|) |b|, so the slope of each of the four
 *   falls by at most |D''| + (w^2 + |w'|) times half the diagonal: neither distance nor radius matters.
 *
 * Both need bounds of w, w', D' and D over the next `cap` seconds, and no step is longer than that. Let c be the vector in
 * whose direction the box is turned, d = |c|, v = |c'|, A a bound of |c''|, and cap = d / (4 (v + sqrt(A d))). With x = v / (v
 * + sqrt(A d)), c moves by at most v cap + A cap^2 / 2 = d (x / 4 + (1 - x)^2 / 32) <= d / 4, and |c'| stays below fast = v + A
 * cap <= v + sqrt(A d) / 4. Hence |w| = |c x c'| / |c|^2 <= fast / (0.75 d), and
 * |w'| = |c x c'' / |c|^2 - 2 w (c.c') / |c|^2| <= A / (0.75 d) + 2 (fast / (0.75 d))^2.
 * Under a central force c x c'' = 0, so |c x c'| is constant (a fixed step makes it vary by less than A cap^2 / (2 d) of it, a
 * 30th). Then |w| <= 1.04 |c x c'| / (0.75 d)^2 and |w'| = 2 |w| |c.c'| / |c|^2 <= 2.08 |c x c'| fast / (0.75 d)^3.
 *
 * A march by second derivatives is slow where the gap stays near 0 for long. After PATIENCE evaluations {@link grazeStep}
 * therefore bounds the gap by the coefficients of the motion.
 * @param r - radius, px
 * @param pull - bound of the circle's own acceleration, px/s²
 */
export function sweptTime(m: Motion, r: number, pull: number, from: number): number {
  const { s, her, toCircle, toTarget, work } = m;
  const { halfWidth, halfHeight, halfDiagonal } = m.box;
  work.guards++;
  const end = s[LENGTH_H];
  const horizon = Math.min(m.horizon, end);
  const turn = s[TURN];
  const dragged = m.kappa + pull;
  const relative = s[ACCELERATION] + (m.integrator.degree === 3 ? CUBIC_BENDS * dragged : dragged);
  // off a line the force is central only if the speed limit holds back no part of it and no steady force turns it aside
  const isFree = s[LIMIT_X] === 0 && s[LIMIT_Y] === 0 && !m.flow.isSteady;
  const central = turn === TURN_TO_BASE && (isFree || s[LINE] !== LINES.NONE);
  const small = smallestStride(end);
  let limit = horizon;
  let t = from;
  let before = t;
  for (let n = 0; ; n++) {
    relativeAt(m, t);
    const dx = toCircle[0];
    const dy = toCircle[1];
    const dvx = toCircle[2];
    const dvy = toCircle[3];
    if (relative === 0 && passesBy(dx, dy, dvx, dvy, r + m.touchMargin)) return -1;
    let cos = s[COS];
    let sin = s[SIN];
    let omega = 0;
    let k = relative;
    let swing = 0;
    let cap = Number.POSITIVE_INFINITY;
    if (turn !== TURN_NOT) {
      // the direction of the box, how fast it turns, and bounds of both ahead
      let bx = -her[0];
      let by = -her[1];
      let bvx = -her[2];
      let bvy = -her[3];
      if (turn === TURN_TO_TARGET) {
        lookAt(m, t);
        bx = toTarget[0];
        by = toTarget[1];
        bvx = toTarget[2];
        bvy = toTarget[3];
      }
      const d2 = bx * bx + by * by;
      const d = Math.sqrt(d2);
      if (d > 0) {
        cos = bx / d;
        sin = by / d;
        const momentum = bx * bvy - by * bvx;
        omega = momentum / d2;
        const v = Math.sqrt(bvx * bvx + bvy * bvy);
        const root = Math.sqrt(relative * d);
        cap = (0.25 * d) / (v + root);
        const fast = v + 0.25 * root;
        const turning = central ? (2.5 * Math.abs(momentum)) / d2 : fast / (0.72 * d);
        const bending = central ? (7 * Math.abs(momentum) * fast) / (d2 * d) : (1.4 * relative) / d + (4 * fast * fast) / d2;
        const speed = Math.sqrt(dvx * dvx + dvy * dvy) + relative * cap;
        const lever = Math.sqrt(dx * dx + dy * dy) + speed * cap;
        swing = bending + turning * turning;
        k += 2 * turning * speed + lever * swing;
      } else if (bvx !== 0 || bvy !== 0) {
        // in the very centre: the direction that she has as soon as she has left it
        const v = Math.sqrt(bvx * bvx + bvy * bvy);
        cos = bvx / v;
        sin = bvy / v;
        cap = 0;
      } else if (n === 0) {
        // the box has no direction, perhaps only for a moment
        cap = 0;
      }
    }
    const lx = dx * cos + dy * sin;
    const ly = dy * cos - dx * sin;
    const gx = Math.abs(lx) - halfWidth;
    const gy = Math.abs(ly) - halfHeight;
    const nx = gx > 0 ? gx : 0;
    const ny = gy > 0 ? gy : 0;
    const norm = nx > 0 ? (ny > 0 ? Math.sqrt(nx * nx + ny * ny) : nx) : ny;
    let g = norm - r;
    let rounding = roundingOfGap(m, r);
    if (g < UNCERTAIN * rounding && g > -UNCERTAIN * rounding) {
      g = fineGap(m, t, r, cos, sin);
      rounding = 0;
    }
    // n, the nearest point, and the slope: n.R^T D' + w (n x q)
    const ax = (lx < 0 ? -nx : nx) / norm;
    const ay = (ly < 0 ? -ny : ny) / norm;
    const qx = gx > 0 ? (lx < 0 ? -halfWidth : halfWidth) : lx;
    const qy = gy > 0 ? (ly < 0 ? -halfHeight : halfHeight) : ly;
    const along = ax * (dvx * cos + dvy * sin) + ay * (dvy * cos - dvx * sin);
    const slope = along + omega * (ax * qy - ay * qx);
    const isBelow = g < 0;
    if (isBelow) {
      const across = Math.sqrt(dvx * dvx + dvy * dvy) + Math.abs(omega) * Math.sqrt(dx * dx + dy * dy);
      const isSteep = slope < 0 && slope * slope > 2 * (k + (across * across) / r) * FLOOR;
      // at the start there is no rounding, so the least overlap counts
      if (isSteep || g < -FLOOR || s[START] + t === 0) {
        if (t === from) return t;
        const time = contactBetween(m, before, t, r, before === from);
        return limit === horizon || Math.abs((time - s[NEXT]) * slope) > FLOOR ? time : s[NEXT];
      }
      g = 0;
    } else if (t > horizon) {
      return -1;
    }
    const above = g + FLOOR - rounding;
    let step = safeStep(above, slope, k);
    if (step < cap && swing > 0 && t + step < limit) {
      step = Math.max(step, cornerStep(m.box, above, ax, ay, qx, qy, along, omega, relative + halfDiagonal * swing));
    }
    if (n >= PATIENCE && step < cap && t + step < limit) {
      work.guards++;
      step = Math.max(Math.min(step, cap), grazeStep(m, t, r, above, ax, ay, qx, qy, cos, sin, omega, swing, cap, limit - t));
    } else {
      step = Math.min(step, cap);
    }
    if (!(t + step < limit)) {
      if (limit === end || !(isBelow || t + safeStep(g - rounding, slope, k) < limit)) return -1;
      // by FLOOR the step may reach beyond an event at the same instant as one that was found before
      limit = end;
      continue;
    }
    if (!isBelow) before = t;
    t = lookNext(t, step, small, limit);
  }
}

/** Whether uniform motion from (dx, dy) by (vx, vy) stays farther than `within` from the origin. */
function passesBy(dx: number, dy: number, vx: number, vy: number, within: number): boolean {
  const aside = dx * vy - dy * vx;
  return aside * aside > within * within * (vx * vx + vy * vy);
}

/** The second bound: the least safe step of the four corners. */
function cornerStep(
  { halfWidth, halfHeight }: Box,
  above: number,
  ax: number,
  ay: number,
  qx: number,
  qy: number,
  along: number,
  omega: number,
  k: number,
): number {
  let step = Number.POSITIVE_INFINITY;
  for (let x = -halfWidth; x <= halfWidth; x += 2 * halfWidth) {
    for (let y = -halfHeight; y <= halfHeight; y += 2 * halfHeight) {
      step = Math.min(step, safeStep(above + ax * (qx - x) + ay * (qy - y), along + omega * (ax * y - ay * x), k));
    }
  }
  return step;
}

/** Gap between her box and the placed circle after `t`, px. */
export function gapAt(m: Motion, t: number, r: number): number {
  const gap = plainGapAt(m, t, r);
  const uncertain = UNCERTAIN * roundingOfGap(m, r);
  return gap < uncertain && gap > -uncertain ? fineGap(m, t, r, look[0], look[1]) : gap;
}

/** The same in plain doubles; its error is {@link roundingOfGap}. */
function plainGapAt(m: Motion, t: number, r: number): number {
  const { s, her, toCircle, toTarget } = m;
  relativeAt(m, t);
  let cos = s[COS];
  let sin = s[SIN];
  if (s[TURN] !== TURN_NOT) {
    let bx = -her[0];
    let by = -her[1];
    if (s[TURN] === TURN_TO_TARGET) {
      lookAt(m, t);
      bx = toTarget[0];
      by = toTarget[1];
    }
    const d = Math.sqrt(bx * bx + by * by);
    if (d > 0) {
      cos = bx / d;
      sin = by / d;
    }
  }
  look[0] = cos;
  look[1] = sin;
  return boxCircleGap(m.box, toCircle[0], toCircle[1], cos, sin, r);
}

/** Rounding error of the gap to a circle that is at `m.toCircle` from her, px. */
function roundingOfGap(m: Motion, r: number): number {
  return DISTANCE_ROUNDING * (Math.abs(m.toCircle[0]) + Math.abs(m.toCircle[1]) + r);
}

/**
 * When she begins to overlap it; `before` itself if she touches there and moves into it.
 * @param touches - whether she may touch at `before`
 */
function contactBetween(m: Motion, before: number, behind: number, r: number, touches: boolean): number {
  m.work.roots++;
  // twice the digits cost twenty times as much: used only where the error of plain ones exceeds what may be overlooked
  const isPlain = !touches && 2 * roundingOfGap(m, r) < FLOOR;
  return overlapBetween(before, behind, isPlain ? (t) => plainGapAt(m, t, r) : (t) => gapAt(m, t, r));
}
