import type { IndexedCircles } from '../indexed-circles.ts';
import { ALERTNESS, type EventRule, type Motion, RECORDS, SLOTS, targetsAround } from '../motion/index.ts';
import { SURPLUS } from '../tolerances.ts';

const { BASE, TARGET, ACCELERATION } = SLOTS;
const { CHASER, ROCK } = RECORDS;
const { AWAKE } = ALERTNESS;

/** Makes the neighbour list anew around (x, y) for a path of length `reach`, px. */
export function refresh(m: Motion, x: number, y: number, reach: number): void {
  const { near } = m;
  const { list } = m.parts;
  // recoil moves asteroids: then the list serves one piece
  near.restart(x, y, m.recoil ? reach : Math.max(2 * reach, 64), m.s[TARGET]);
  for (let k = 0; k < list.length; k++) list[k].list?.(m);
  m.budget.look(near.count >> 2);
}

/** Distance of a place (px in the level) from where the neighbour list is made, px. */
export function distanceToNear(m: Motion, x: number, y: number): number {
  const dx = x - m.originX - m.near.x;
  const dy = y - m.originY - m.near.y;
  return Math.sqrt(dx * dx + dy * dy);
}

/** Calls `visit` with at least all circles that reach nearer than `within` px to where the neighbour list is made. */
export function eachCircleNear(m: Motion, circles: IndexedCircles, within: number, visit: (i: number) => void): void {
  const { spatial } = circles;
  if (spatial === null) {
    for (let i = 0; i < circles.count; i++) visit(i);
    return;
  }
  const found = spatial.around(m.near.x + m.originX, m.near.y + m.originY, within);
  m.budget.look(found.length >> 2);
  for (const i of found) visit(i);
}

/** Lists the circles that stand still and that she may touch. */
export function listTouching(m: Motion, rule: EventRule, circles: IndexedCircles): void {
  const { near } = m;
  eachCircleNear(m, circles, near.skin + m.touchMargin, (i) => {
    near.add(rule.kind, i, distanceToNear(m, circles.x[i], circles.y[i]) - circles.r[i] - m.touchMargin);
  });
}

/** Lists the circles that stand still and whose rims her centre may cross. */
export function listRims(m: Motion, rule: EventRule, circles: IndexedCircles): void {
  const { near } = m;
  eachCircleNear(m, circles, near.skin + m.touchMargin, (i) => {
    near.add(rule.kind, i, Math.abs(distanceToNear(m, circles.x[i], circles.y[i]) - circles.r[i]) - SURPLUS);
  });
}

/** Distance of a target from where the neighbour list is made, at the start of the piece, px. */
export function rockDistanceToNear(m: Motion, i: number): number {
  const { s, near } = m;
  const dx = (m.recoil ? s[m.rocks + ROCK * i] : m.targetX[i]) - near.x;
  const dy = (m.recoil ? s[m.rocks + ROCK * i + 1] : m.targetY[i]) - near.y;
  return Math.sqrt(dx * dx + dy * dy);
}

/**
 * Upper bound of how far she moves in `h` s of the current piece, px. Objects farther away are not examined, so a bound that is
 * too small would miss contacts.
 * @param speed - her speed at the start of the piece, px/s
 */
export function ownTravel(m: Motion, speed: number, h: number): number {
  const bend = m.s[ACCELERATION] / 2 + m.kappa;
  if (bend > 0) return (speed + bend * h) * h;
  return speed > 0 ? speed * h : 0;
}

/** Upper bound of how far any asteroid moves in `h` s, drifting or by recoil, px. */
export function farthestRockTravel(m: Motion, h: number): number {
  const { s } = m;
  let fastest = 0;
  for (const i of m.stirred) {
    const o = m.rocks + ROCK * i;
    fastest = Math.max(fastest, s[o + 2] * s[o + 2] + s[o + 3] * s[o + 3]);
  }
  const v = Math.sqrt(Math.max(fastest, baseSpeedSquared(m)));
  const a = m.kappa;
  return v > 0 || a > 0 ? (v + a * h) * h : 0;
}

/** (px/s)². The base's record can have its velocity at an earlier event; its polynomial has that of the current piece. */
const baseSpeedSquared = ({ px, py }: Motion): number => px[1] * px[1] + py[1] * py[1];

/** Upper bound of how far a target moves in `h` s, px. */
export function rockTravel(m: Motion, i: number, h: number): number {
  const { s } = m;
  if (!m.recoil) return 0;
  const o = m.rocks + ROCK * i;
  const recorded = s[o + 2] * s[o + 2] + s[o + 3] * s[o + 3];
  const v = Math.sqrt(i === s[BASE] ? Math.max(recorded, baseSpeedSquared(m)) : recorded);
  const a = i === s[TARGET] ? m.kappa : 0;
  return v > 0 || a > 0 ? (v + a * h) * h : 0;
}

/**
 * Upper bound of how far a chaser moves in `h` s, px.
 * @param pull - its acceleration while it is awake, px/s²
 */
export function chaserTravel(m: Motion, i: number, pull: number, h: number): number {
  const { s } = m;
  const o = m.chasers + CHASER * i;
  if (s[o + 4] !== AWAKE) return 0;
  return (Math.sqrt(s[o + 2] * s[o + 2] + s[o + 3] * s[o + 3]) + pull * h) * h;
}

/**
 * Calls `visit` with at least all targets, from index `first` on, that reach nearer than `within` px to where the neighbour
 * list is made.
 */
export function eachTargetNear(m: Motion, within: number, first: number, visit: (i: number) => void): void {
  const { targets } = m.scene;
  if (targets.spatial === null) {
    for (let i = first; i < targets.count; i++) visit(i);
    return;
  }
  if (!m.recoil) {
    eachCircleNear(m, targets, within, (i) => {
      if (i >= first) visit(i);
    });
    return;
  }
  for (const i of targetsAround(m, m.near.x, m.near.y, within)) if (i >= first) visit(i);
}
