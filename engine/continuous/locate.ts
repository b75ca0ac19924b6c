import { ALIEN_PULL, ALIEN_SIGHT, HALF_DIAGONAL, SPEED_LIMIT } from '../constants.ts';
import { placeAlien, placeCircle, placeRock, SERIES } from './circle.ts';
import { NOBODY } from './crowd.ts';
import { justFired, offer } from './first-event.ts';
import { LINEAR, SLIDE } from './flow.ts';
import { considerPair } from './guards/alien-pair.ts';
import { centreTime, meetingTime } from './guards/centre.ts';
import { comeOffTime } from './guards/come-off.ts';
import { contactTime } from './guards/contact.ts';
import { rimTime } from './guards/rim.ts';
import { considerLimits } from './guards/speed-limit.ts';
import { switchTime } from './guards/target-switch.ts';
import type { Motion } from './motion.ts';
import { alienTravel, farthestRockTravel, refresh } from './neighbourhood.ts';
import { placeAt } from './places.ts';
import { tolerance } from './slide.ts';
import { EVENTS, MEETINGS, RECORDS, SLOTS } from './state.ts';

const {
  START,
  FROM,
  NEXT,
  EVENT,
  TARGET,
  COVER,
  BASE_X,
  BASE_Y,
  KIND,
  LIMIT_X,
  LIMIT_Y,
  LENGTH_H,
  ACCELERATION,
  AWAKE_COUNT,
  RIM,
  MEETS,
} = SLOTS;
const {
  MINERAL,
  NOVA,
  HOT,
  ALIEN_TOUCH,
  HOLE,
  LEAVE_COVER,
  CENTRE,
  SWITCH,
  ENTER,
  LEAVE,
  WAKE,
  SLEEP,
  PAIR,
  COME_OFF,
  PIECE_END,
} = EVENTS;
const { CHASER, ROCK } = RECORDS;
const { AHEAD, BEHIND } = MEETINGS;

/** What overlaps at the start is over by then, s. */
const AT_THE_START = 1e-9;

/** Locates the first event in (FROM, LENGTH_H] of the piece; the natural end where nothing happens before. */
export function locate(m: Motion): void {
  const { s, e, near } = m;
  s[NEXT] = s[LENGTH_H];
  s[EVENT] = PIECE_END;
  const from = s[FROM];
  // the path stays within `reach` of its start
  placeAt(m, 0);
  const x = s[BASE_X] + e[0];
  const y = s[BASE_Y] + e[1];
  const speedX = e[2] + (m.recoil ? e[6] : 0);
  const speedY = e[3] + (m.recoil ? e[7] : 0);
  const h = s[LENGTH_H];
  const speed = Math.sqrt(speedX * speedX + speedY * speedY);
  const travel = s[ACCELERATION] > 0 ? (speed + (s[ACCELERATION] + m.kappa) * h) * h : speed > 0 ? speed * h : 0;
  const rocks = m.recoil ? farthestRockTravel(m, h) : 0;
  const reach = travel + rocks;

  // what comes later than this is none of hers
  if (s[KIND] === SLIDE) offer(m, comeOffTime(m, from), COME_OFF, 0, 0);
  if (m.recoil || !near.covers(x, y, reach, s[TARGET])) refresh(m, x, y, reach);
  const gone = Math.sqrt((x - near.x) * (x - near.x) + (y - near.y) * (y - near.y)) + reach;
  m.budget.look((near.count + m.stirred.length) >> 4);
  for (let i = 0; i < near.count; i++) {
    if (near.slack[i] > gone) continue;
    consider(m, near.kind[i], near.index[i], from);
  }
  const { explosions } = m.scene.aliens;
  if (s[AWAKE_COUNT] > 0 || (s[START] < AT_THE_START && explosions.length > 0)) considerAwake(m, x, y, travel, from);
  considerCover(m, x, y, reach, from);
  if (s[KIND] === LINEAR) offer(m, centreTime(m, from), CENTRE, 0, 0);
  if (s[MEETS] === AHEAD || s[MEETS] === BEHIND) offer(m, meetingTime(m, from), CENTRE, 1, 0);
  if (speed + (s[ACCELERATION] + m.kappa) * h >= SPEED_LIMIT || s[LIMIT_X] !== 0 || s[LIMIT_Y] !== 0) considerLimits(m, from);
}

/** Tests one entry of the neighbour list. */
function consider(m: Motion, kind: number, i: number, from: number): void {
  const { s, scene } = m;
  switch (kind) {
    case NOVA:
      placeCircle(m, scene.novae.x[i], scene.novae.y[i], m.originX, m.originY);
      offer(m, contactTime(m, scene.novae.r[i], 0, from), NOVA, scene.novae.index[i], 0);
      return;
    case HOT:
      placeRock(m, i);
      offer(m, contactTime(m, scene.targets.r[i], m.kappa, from), HOT, i, 0);
      return;
    case HOLE: {
      const { x, y, radius } = scene.level.blackHole;
      placeCircle(m, x, y, m.originX, m.originY);
      offer(m, contactTime(m, radius, 0, from), HOLE, 0, 0);
      return;
    }
    case MINERAL:
      if (s[m.minerals + i] !== 0) return;
      placeCircle(m, scene.minerals.x[i], scene.minerals.y[i], m.originX, m.originY);
      offer(m, contactTime(m, scene.minerals.r[i], 0, from), MINERAL, i, 0);
      return;
    case ENTER: {
      const inside = s[m.inside + i] === 1;
      const event = inside ? LEAVE : ENTER;
      if (s[RIM] === i) return;
      placeCircle(m, scene.repulsors.x[i], scene.repulsors.y[i], m.originX, m.originY);
      const r = scene.repulsors.r[i] + (inside ? tolerance(m, i) : -tolerance(m, i));
      offer(m, rimTime(m, r, !inside, 0, from, justFired(m, event, i)), event, i, 0);
      return;
    }
    case WAKE:
      considerRim(m, i, WAKE, from);
      return;
    case ALIEN_TOUCH:
      considerAlienTouch(m, i, from);
      return;
    default:
      offer(m, switchTime(m, i, from), SWITCH, i, 0);
  }
}

/** Aliens that are awake, and pairs with one of them, those asleep are in the neighbour list; at the start those that overlap, too. */
function considerAwake(m: Motion, x: number, y: number, travel: number, from: number): void {
  const { s, crowd } = m;
  const { aliens } = m.scene;
  const { explosions } = aliens;
  const h = s[LENGTH_H];
  // the first two that overlap where the level has them, asleep; one that is awake is told with its pairs
  let overlap = explosions.length > 0 ? crowd.overlapAtStart() : -1;
  const count = s[AWAKE_COUNT] > 0 ? crowd.meetings(h) : 0;
  for (let k = 0; k < count; k++) {
    const i = crowd.first[k];
    const j = crowd.second[k];
    if (overlap >= 0 && explosions[overlap] <= i) {
      considerPair(m, explosions[overlap], explosions[overlap + 1], from);
      overlap = -1;
    }
    if (j !== NOBODY) {
      // two that touch at once are found: other pairs come later
      if (s[EVENT] > PAIR || s[NEXT] - m.sameInstant > from) considerPair(m, i, j, from);
      continue;
    }
    const o = m.chasers + CHASER * i;
    const d = Math.sqrt((s[o] - x) * (s[o] - x) + (s[o + 1] - y) * (s[o + 1] - y));
    const moves = travel + alienTravel(m, i, h);
    if (d + moves > ALIEN_SIGHT - 1e-6) considerRim(m, i, SLEEP, from);
    if (d - moves < aliens.r[i] + HALF_DIAGONAL + 1e-6) considerAlienTouch(m, i, from);
  }
  if (overlap >= 0) considerPair(m, explosions[overlap], explosions[overlap + 1], from);
}

function considerRim(m: Motion, i: number, event: number, from: number): void {
  placeAlien(m, i);
  const pull = event === SLEEP ? ALIEN_PULL : 0;
  offer(m, rimTime(m, ALIEN_SIGHT, event === WAKE, pull, from, justFired(m, event, i)), event, i, 0);
}

function considerAlienTouch(m: Motion, i: number, from: number): void {
  placeAlien(m, i);
  const pull = m.circleMotion === SERIES ? ALIEN_PULL : 0;
  offer(m, contactTime(m, m.scene.aliens.r[i], pull, from), ALIEN_TOUCH, i, 0);
}

/**
 * The asteroid that keeps her in range: when she leaves its range another may take over, or she is lost.
 * @param x, y where she is at the start of the piece, px from the origin
 * @param reach how much farther from it she may be on the piece, px
 */
function considerCover(m: Motion, x: number, y: number, reach: number, from: number): void {
  const { s, scene } = m;
  const cover = s[COVER];
  if (cover < 0) {
    offer(m, from, LEAVE_COVER, -1, 0);
    return;
  }
  const { range } = scene.level;
  const within = range - reach - 1e-6;
  const o = m.rocks + ROCK * cover;
  const dx = (m.recoil ? s[o] : m.targetX[cover]) - x;
  const dy = (m.recoil ? s[o + 1] : m.targetY[cover]) - y;
  if (within > 0 && dx * dx + dy * dy < within * within) return;
  placeRock(m, cover);
  offer(m, rimTime(m, range, false, m.kappa, from, false), LEAVE_COVER, cover, 0);
}
