import { beginLine, holdsTarget, LINEAR, LINES, MEETINGS, type Motion, RECORDS, SLOTS } from '../../motion/index.ts';
import { SMALLEST_ORBIT } from '../../tolerances.ts';

const { TARGET, KIND, BASE_X, BASE_Y, COS, SIN, SIDE, LINE_X, LINE_Y, LINE, LINE_STEEP, MEETS } = SLOTS;
const { ROCK } = RECORDS;
const { NONE } = LINES;
const { AHEAD, BEHIND, TOGETHER } = MEETINGS;

/**
 * She is held inside a field. If the target is on her line, it is ahead of her or behind her until they meet, which is an
 * event: there the box flips, and so does the acceleration of a target that is dragged along. A target that would swing about
 * her by less than {@link SMALLEST_ORBIT} stays in her centre: it is accelerated as she is, which the gun is strong enough to
 * do.
 * @returns whether it is on the line; if not, the box follows it
 */
export function holdOnLine(m: Motion): boolean {
  const { s, ux, uy, recoil } = m;
  const target = s[TARGET];
  const o = m.rocks + ROCK * target;
  const x = (recoil ? s[o] : m.targetX[target]) - s[BASE_X] - ux[0];
  const y = (recoil ? s[o + 1] : m.targetY[target]) - s[BASE_Y] - uy[0];
  const vx = (recoil ? s[o + 2] : 0) - ux[1];
  const vy = (recoil ? s[o + 3] : 0) - uy[1];
  // at rest in the centre of the field any line through it is hers, unless a steady force drives her along one
  const rests = !m.flow.isSteady && ux[0] === 0 && uy[0] === 0 && ux[1] === 0 && uy[1] === 0;
  if (rests && (s[LINE] === NONE || !holdsTarget(m, target))) {
    if (x !== 0 || y !== 0) beginLine(m, x, y);
    else if (vx !== 0 || vy !== 0) beginLine(m, vx, vy);
  }
  if (!holdsTarget(m, target)) return false;

  const steep = s[LINE_STEEP] === 1;
  const main = steep ? s[LINE_Y] : s[LINE_X];
  const along = (steep ? y : x) / main;
  const speed = (steep ? vy : vx) / main;
  const push = s[KIND] === LINEAR ? s[SIDE] * m.rules.push : 0;
  const strongest = Math.abs(push) + m.flow.steadyStrength;
  const back = m.kappa - strongest;
  const energy = (speed * speed) / 2 + (m.kappa + strongest) * Math.abs(along);
  if (back > 0 ? energy < back * SMALLEST_ORBIT : along === 0 && speed === 0 && push === 0) {
    s[MEETS] = TOGETHER;
    if (!recoil) return true;
    s[o] = s[BASE_X] + ux[0];
    s[o + 1] = s[BASE_Y] + uy[0];
    s[o + 2] = ux[1];
    s[o + 3] = uy[1];
    return true;
  }
  // what no force holds in her centre stays behind when the push takes her away
  const side = along !== 0 ? along : speed !== 0 ? speed : -push;
  s[MEETS] = side < 0 ? BEHIND : AHEAD;
  s[COS] = s[MEETS] * s[LINE_X];
  s[SIN] = s[MEETS] * s[LINE_Y];
  return true;
}

/** Puts the target into her very centre, exact to the last bit along the line. */
export function putInCentre(m: Motion): void {
  const { s, ux, uy, recoil } = m;
  const target = s[TARGET];
  const o = m.rocks + ROCK * target;
  if (ux[0] === 0 && uy[0] === 0 && ux[1] === 0 && uy[1] === 0) {
    // at rest in the centre of the field the smallest displacement would grow; at the speed limit she may pass the centre
    s[o] = s[BASE_X];
    s[o + 1] = s[BASE_Y];
    return;
  }
  // the other coordinate follows from the line
  if (s[LINE_STEEP] === 1) uy[0] = (recoil ? s[o + 1] : m.targetY[target]) - s[BASE_Y];
  else ux[0] = (recoil ? s[o] : m.targetX[target]) - s[BASE_X];
}
