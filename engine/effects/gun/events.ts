import { eachTargetNear, eventRule, justFired, offer, quietWithin, rockDistanceToNear } from '../../events/index.ts';
import { distanceSquared, GOES_ON, LINEAR, MEETINGS, type Motion, SLOTS } from '../../motion/index.ts';
import { SURPLUS } from '../../tolerances.ts';
import { centreTime, meetingTime, putInCentre } from './line.ts';
import { skipPeriods } from './orbits.ts';
import { countSwitch, quietUntilSwitch, recordTarget, switchTime } from './target.ts';

const { TARGET, COVER, KIND, MEETS, LAST_EVENT, LAST_A } = SLOTS;
const { NOT, AHEAD, BEHIND } = MEETINGS;

/** On a line she passes the centre of the force, where the direction of the force flips. */
export const passCentre = eventRule({
  name: 'centre',
  keepsPeriod: true,
  always(m, from) {
    if (m.s[KIND] === LINEAR) offer(m, centreTime(m, from), passCentre.kind, 0, 0);
  },
  alwaysQuiet(m, time) {
    const { s, ux, uy, path } = m;
    if (s[KIND] !== LINEAR) return time;
    return quietWithin(m, Math.sqrt(ux[0] * ux[0] + uy[0] * uy[0]), -path.speed, time);
  },
  fire(m) {
    m.ux[0] = 0;
    m.uy[0] = 0;
    skipPeriods(m);
    return GOES_ON;
  },
});

/** Held inside a field, she meets a target that is on her line. */
export const meetTarget = eventRule({
  name: 'meeting',
  always(m, from) {
    const meets = m.s[MEETS];
    if (meets === AHEAD || meets === BEHIND) offer(m, meetingTime(m, from), meetTarget.kind, 0, 0);
  },
  alwaysQuiet(m, time) {
    if (m.s[MEETS] === NOT) return time;
    return quietWithin(m, Math.sqrt(distanceSquared(m, m.s[TARGET])), -m.path.speed, time);
  },
  fire(m) {
    putInCentre(m);
    return GOES_ON;
  },
});

/** Whether asteroid `i` stands still in the same place as the target: then the first of them stays the target. */
function isInSamePlace(m: Motion, i: number): boolean {
  const target = m.s[TARGET];
  return !m.recoil && m.targetX[i] === m.targetX[target] && m.targetY[i] === m.targetY[target];
}

/** Another asteroid becomes the nearest while the gun is held. */
export const switchTarget = eventRule({
  name: 'target',
  list(m) {
    const { s, near } = m;
    const target = s[TARGET];
    if (target < 0) return;
    const own = rockDistanceToNear(m, target);
    eachTargetNear(m, 2 * near.skin + own + 1e-3, 0, (i) => {
      if (i !== target) near.add(switchTarget.kind, i, (rockDistanceToNear(m, i) - own) / 2 - SURPLUS);
    });
  },
  isOver: isInSamePlace,
  guard(m, i, from) {
    offer(m, switchTime(m, i, from, justFired(m, switchTarget.kind, i)), switchTarget.kind, i, 0);
  },
  quiet: quietUntilSwitch,
  fire(m, i, _b, time) {
    const { s } = m;
    countSwitch(m, time);
    s[LAST_EVENT] = switchTarget.kind;
    s[LAST_A] = s[TARGET];
    s[TARGET] = i;
    s[COVER] = i;
    recordTarget(m, time);
    return GOES_ON;
  },
});
