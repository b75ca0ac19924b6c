import type { IndexedCircles } from '../indexed-circles.ts';
import { ALERTNESS, circlesAround, type EventRule, type Motion, RECORDS, SLOTS, targetsAround } from '../motion/index.ts';
import { SURPLUS } from '../tolerances.ts';

const { BASE, TARGET, ACCELERATION } = SLOTS;
const { CHASER, ROCK } = RECORDS;
const { AWAKE } = ALERTNESS;

/** Makes the neighbour list anew around (x, y) for a path of length `reach`, px. */
export function refresh(m: Motion, x: number, y: number, reach: number): void {
  // recoil moves asteroids: then the list serves one piece
  makeList(m, x, y, m.recoil ? reach : Math.max(2 * reach, 64), false);
  m.budget.look(m.near.count >> 2);
}

/**
 * Makes the list anew in the order of the index, which depends on how far it looks. The last digit of a tie between two objects
 * of one kind can depend on their order.
 */
export const sortNeighbours = (m: Motion): void => makeList(m, m.near.x, m.near.y, m.near.skin, true);

function makeList(m: Motion, x: number, y: number, skin: number, isStrict: boolean): void {
  const { near, vicinities } = m;
  const { list } = m.parts;
  near.restart(x, y, skin, m.s[TARGET]);
  near.isStrict = isStrict;
  for (let k = 0; k < list.length; k++) {
    if (!vicinities[list[k].kind].isEmpty(x + m.originX, y + m.originY, skin + m.touchMargin)) list[k].list?.(m);
  }
}

/** Distance of a place (px in the level) from where the neighbour list is made, px. */
export function distanceToNear(m: Motion, x: number, y: number): number {
  const dx = x - m.originX - m.near.x;
  const dy = y - m.originY - m.near.y;
  return Math.sqrt(dx * dx + dy * dy);
}

/** The first indices: none, one, and so on. Of so few objects it is no use to look for fewer. */
const FIRST: readonly (readonly number[])[] = [[], [0], [0, 1], [0, 1, 2], [0, 1, 2, 3]];

/**
 * Indices of at least all circles, from index `first` on, and perhaps of some before, that reach nearer than `within` px to
 * where the neighbour list is made.
 * @param rule - the kind of event that they are looked for
 */
function circlesNear(m: Motion, rule: EventRule, circles: IndexedCircles, within: number, first: number): ArrayLike<number> {
  const { near } = m;
  const { spatial, count } = circles;
  if (count < FIRST.length) return FIRST[count];
  if (near.isStrict && spatial !== null) {
    const found = spatial.around(near.x + m.originX, near.y + m.originY, within);
    m.budget.look(found.length >> 2);
    return found;
  }
  const vicinity = m.vicinities[rule.kind];
  const found = circlesAround(m, vicinity, circles, near.x, near.y, within, first);
  if (spatial !== null && found.length > 1 && found === vicinity.found) near.isRough = true;
  return found;
}

/** Lists the circles that stand still and that she may touch. */
export function listTouching(m: Motion, rule: EventRule, circles: IndexedCircles): void {
  const { near } = m;
  const found = circlesNear(m, rule, circles, near.skin + m.touchMargin, 0);
  for (let k = 0; k < found.length; k++) {
    const i = found[k];
    near.add(rule.kind, i, distanceToNear(m, circles.x[i], circles.y[i]) - circles.r[i] - m.touchMargin);
  }
}

/** Lists the circles that stand still and whose rims her centre may cross. */
export function listRims(m: Motion, rule: EventRule, circles: IndexedCircles): void {
  const { near } = m;
  const found = circlesNear(m, rule, circles, near.skin + m.touchMargin, 0);
  for (let k = 0; k < found.length; k++) {
    const i = found[k];
    near.add(rule.kind, i, Math.abs(distanceToNear(m, circles.x[i], circles.y[i]) - circles.r[i]) - SURPLUS);
  }
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

/** The same of targets, wherever recoil has moved them. */
export function targetsNear(m: Motion, rule: EventRule, within: number, first: number): ArrayLike<number> {
  const { near, recoil, stirred } = m;
  const { targets } = m.scene;
  if (!recoil || first > 0 || targets.count < FIRST.length) {
    const atHome = circlesNear(m, rule, targets, within, first);
    const isAll = !recoil || targets.count < FIRST.length;
    if (isAll || (atHome.length === 0 && !(stirred[stirred.length - 1] >= first))) return atHome;
  }
  return targetsAround(m, near.x, near.y, within);
}
