import { farthestRockTravel, ownTravel, refresh } from '../events/index.ts';
import { type Motion, ONSETS, PIECE_END, placeAt, SLOTS } from '../motion/index.ts';

const { FROM, NEXT, EVENT, ONSET, TARGET, BASE_X, BASE_Y, LENGTH_H } = SLOTS;

/** Locates the first event in (FROM, LENGTH_H] of the piece; the natural end if nothing happens before. */
export function locate(m: Motion): void {
  const { s, her, base, near, path, parts } = m;
  s[NEXT] = s[LENGTH_H];
  s[EVENT] = PIECE_END;
  s[ONSET] = ONSETS.COMES;
  const from = s[FROM];
  // the path stays within `reach` of its start
  placeAt(m, 0);
  const x = s[BASE_X] + her[0];
  const y = s[BASE_Y] + her[1];
  const vx = her[2] + (m.recoil ? base[2] : 0);
  const vy = her[3] + (m.recoil ? base[3] : 0);
  const h = s[LENGTH_H];
  const speed = Math.sqrt(vx * vx + vy * vy);
  const travel = ownTravel(m, speed, h);
  const rocks = m.recoil ? farthestRockTravel(m, h) : 0;
  const reach = travel + rocks;

  const { first, always, byKind } = parts;
  for (let k = 0; k < first.length; k++) first[k].first?.(m, from);
  if (m.recoil || !near.covers(x, y, reach, s[TARGET])) refresh(m, x, y, reach);
  const gone = Math.sqrt((x - near.x) * (x - near.x) + (y - near.y) * (y - near.y)) + reach;
  m.budget.look((near.count + m.stirred.length) >> 4);
  for (let i = 0; i < near.count; i++) {
    if (near.slack[i] > gone) continue;
    byKind[near.kind[i]].guard?.(m, near.index[i], from);
  }
  path.x = x;
  path.y = y;
  path.vx = vx;
  path.vy = vy;
  path.speed = speed;
  path.travel = travel;
  path.reach = reach;
  for (let k = 0; k < always.length; k++) always[k].always?.(m, from);
}
