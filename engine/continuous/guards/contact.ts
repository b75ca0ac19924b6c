import { HALF_HEIGHT, HALF_WIDTH } from '../../constants.ts';
import { boxCircleGap } from '../../contact/index.ts';
import { bisect } from '../bracket.ts';
import { relativeAt } from '../circle.ts';
import { safeStep, smallestStride } from '../march.ts';
import type { Motion } from '../motion.ts';
import { lookAt } from '../places.ts';
import { SLOTS, TURNS } from '../state.ts';

const { START, TURN, COS, SIN, LENGTH_H, ACCELERATION } = SLOTS;
const { TURN_NOT, TURN_TO_BASE, TURN_TO_TARGET } = TURNS;

/**
 * First time at which a contact with the placed circle counts: when it happens, or is seen at a frame.
 * @param r radius, px
 * @param pull bound on the circle's own acceleration, px/s2
 * @param from s from the start of the piece
 * @returns s from there, too; -1: not before the piece ends
 */
export function contactTime(m: Motion, r: number, pull: number, from: number): number {
  const { s, frameRate } = m;
  let t = sweptTime(m, r, pull, from);
  if (frameRate === 0) return t;
  // a contact seen at a frame lies within an overlap; one that is over before the next frame is missed, as games do
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
 * First time in [from, horizon] at which her box overlaps the placed circle, or -1. The gap of a convex box is a
 * convex function of the circle's place in the box's frame, so its tangent bounds it from below; what the curvature
 * of the path and the turning of the box can take away is bounded by `k`: the march can't step over a contact.
 * @param r radius, px
 * @param pull bound on the circle's own acceleration, px/s2
 */
function sweptTime(m: Motion, r: number, pull: number, from: number): number {
  const { s, e, work } = m;
  work.guards++;
  const horizon = Math.min(m.horizon, s[LENGTH_H]);
  const turn = s[TURN];
  const acceleration = s[ACCELERATION] + m.kappa;
  const relative = acceleration + pull;
  const central = turn === TURN_TO_BASE;
  let small = smallestStride(s[LENGTH_H]);
  let t = from;
  let before = t;
  for (let n = 0; ; n++) {
    relativeAt(m, t);
    const dx = e[4];
    const dy = e[5];
    const dvx = e[6];
    const dvy = e[7];
    let cos = s[COS];
    let sin = s[SIN];
    let omega = 0;
    let k = relative;
    let cap = Number.POSITIVE_INFINITY;
    if (turn !== TURN_NOT) {
      // the direction the box looks in, how fast it turns, and bounds on both ahead
      let bx = -e[0];
      let by = -e[1];
      let bvx = -e[2];
      let bvy = -e[3];
      if (!central) {
        lookAt(m, t);
        bx = e[8];
        by = e[9];
        bvx = e[10];
        bvy = e[11];
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
        // within the cap the distance stays above 0.72 d and the speed below `fast`
        cap = (0.25 * d) / (v + root);
        const fast = v + 0.25 * root;
        const turning = central ? (2.5 * Math.abs(momentum)) / d2 : fast / (0.72 * d);
        const bending = central ? (7 * Math.abs(momentum) * fast) / (d2 * d) : (1.4 * relative) / d + (4 * fast * fast) / d2;
        const speed = Math.sqrt(dvx * dvx + dvy * dvy) + relative * cap;
        const lever = Math.sqrt(dx * dx + dy * dy) + speed * cap;
        k += 2 * turning * speed + lever * (bending + turning * turning);
      } else if (bvx !== 0 || bvy !== 0) {
        // in the very centre: the way she will look as soon as she has left it
        const v = Math.sqrt(bvx * bvx + bvy * bvy);
        cos = bvx / v;
        sin = bvy / v;
      }
    }
    const lx = dx * cos + dy * sin;
    const ly = dy * cos - dx * sin;
    const gx = Math.abs(lx) - HALF_WIDTH;
    const gy = Math.abs(ly) - HALF_HEIGHT;
    const nx = gx > 0 ? gx : 0;
    const ny = gy > 0 ? gy : 0;
    const norm = nx > 0 ? (ny > 0 ? Math.sqrt(nx * nx + ny * ny) : nx) : ny;
    const g = norm - r;
    if (g < 0) return t === from ? t : contactBetween(m, before, t, r);
    const lvx = dvx * cos + dvy * sin + omega * ly;
    const lvy = dvy * cos - dvx * sin - omega * lx;
    const slope = ((lx < 0 ? -nx : nx) * lvx + (ly < 0 ? -ny : ny) * lvy) / norm;
    const step = Math.min(cap, safeStep(g, slope, k));
    if (!(t + step < horizon)) return -1;
    if (n > 400) small *= 2;
    before = t;
    t = Math.min(horizon, t + Math.max(step, small));
  }
}

/** Gap between her box and the placed circle after `t`, px. */
function gapAt(m: Motion, t: number, r: number): number {
  const { s, e } = m;
  relativeAt(m, t);
  let cos = s[COS];
  let sin = s[SIN];
  if (s[TURN] !== TURN_NOT) {
    let bx = -e[0];
    let by = -e[1];
    if (s[TURN] === TURN_TO_TARGET) {
      lookAt(m, t);
      bx = e[8];
      by = e[9];
    }
    const d = Math.sqrt(bx * bx + by * by);
    if (d > 0) {
      cos = bx / d;
      sin = by / d;
    }
  }
  return boxCircleGap(e[4], e[5], cos, sin, r);
}

function contactBetween(m: Motion, before: number, behind: number, r: number): number {
  m.work.roots++;
  return bisect(before, behind, (t) => gapAt(m, t, r) < 0);
}
