import { eventRule, justFired, offer, quietWithin, rockDistanceToNear, targetsNear } from '../../events/index.ts';
import {
  CENTRAL,
  type CentralForce,
  distanceSquared,
  FOLLOWERS,
  GOES_ON,
  LINEAR,
  layOutRocks,
  MEETINGS,
  type Motion,
  RECORDS,
  rebase,
  SLOTS,
  stir,
  TURNS,
} from '../../motion/index.ts';
import { SURPLUS } from '../../tolerances.ts';
import { type Effect, whereAny } from '../effect.ts';
import { centreTime, holdOnLine, meetingTime, putInCentre } from './line.ts';
import { isTiny, skipOrbits, skipPeriods } from './orbits.ts';
import { countSwitch, holdNearest, quietUntilSwitch, recordTarget, switchTime } from './target.ts';

export { recordTarget } from './target.ts';

const { HELD, TARGET, FIELD, KIND, TURN, COS, SIN, SIDE, LINE_X, LINE_Y, COVER, MEETS, LAST_EVENT, LAST_A } = SLOTS;
const { ROCK } = RECORDS;
const { TURN_TO_BASE, TURN_TO_TARGET } = TURNS;
const { NOT, AHEAD, BEHIND } = MEETINGS;

/** The pull of the gun towards its target: pull (1 - d / range). */
const gunPull: CentralForce = {
  acts: 'instead',
  strongest: (_level, { pull }) => pull,
  isActing: ({ s }) => s[HELD] === 1,
  centre(m) {
    const { s } = m;
    const target = s[TARGET];
    if (!m.recoil) {
      rebase(m, target, m.targetX[target], m.targetY[target], 0, 0);
      return;
    }
    const o = m.rocks + ROCK * target;
    rebase(m, target, s[o], s[o + 1], s[o + 2], s[o + 3]);
  },
  set(m: Motion) {
    const { flow, rules, kappa } = m;
    const { range } = m.scene.level;
    flow.alpha = -(rules.pull + kappa);
    flow.beta = rules.pull / range;
    flow.pull = rules.pull;
    flow.range = range;
    flow.extra = -kappa;
  },
  swing(m, d, v) {
    const left = m.rules.pull - m.flow.steadyStrength;
    return left > 0 ? d + (v * v) / (2 * left) : Number.POSITIVE_INFINITY;
  },
};

/** On a line she passes the centre of the force, where the direction of the force flips. */
const passCentre = eventRule({
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
const meetTarget = eventRule({
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
const switchTarget = eventRule({
  name: 'target',
  list(m) {
    const { s, near } = m;
    const target = s[TARGET];
    if (target < 0) return;
    const own = rockDistanceToNear(m, target);
    const found = targetsNear(m, switchTarget, 2 * near.skin + own + 1e-3, 0);
    for (let k = 0; k < found.length; k++) {
      const i = found[k];
      if (i !== target) near.add(switchTarget.kind, i, (rockDistanceToNear(m, i) - own) / 2 - SURPLUS);
    }
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

export const gun: Effect = {
  name: 'gun',
  summary: ({ pull }) =>
    `while held, pulls her towards the nearest asteroid at ${pull} (1 - d / range) px/s2 and turns her towards it`,
  calledFor: whereAny('asteroids', 'asteroid'),
  rules: ['pull'],
  force: gunPull,
  beforePiece(m) {
    if (m.recoil && m.s[HELD] === 1) stir(m, m.s[TARGET]);
  },
  moved: holdNearest,
  turn: turnToTarget,
  repeat: skipOrbits,
  mayRepeat: (m) => isTiny(m, 4),
  events: [passCentre, meetTarget, switchTarget],
};

/** Sets how the box turns: while the gun is held it points at the target. */
function turnToTarget(m: Motion): void {
  const { s } = m;
  if (s[HELD] === 0) return;
  if (s[FIELD] >= 0) {
    if (!holdOnLine(m)) s[TURN] = TURN_TO_TARGET;
    return;
  }
  if (s[KIND] === CENTRAL) s[TURN] = TURN_TO_BASE;
  if (s[KIND] !== LINEAR) return;
  s[COS] = -s[SIDE] * s[LINE_X];
  s[SIN] = -s[SIDE] * s[LINE_Y];
}

export const recoil: Effect = {
  name: 'recoil',
  summary: ({ recoil: strength }) =>
    `the target of the gun accelerates towards her at ${strength} / diameter px/s2 and keeps its velocity after release`,
  calledFor: (level) => {
    if (!level.recoil) return { called: false, because: 'the level does not turn recoil on' };
    if (level.asteroids.length === 0) return { called: false, because: 'no asteroids' };
    return { called: true, because: 'the level turns recoil on' };
  },
  rules: ['recoil'],
  moves: true,
  following: FOLLOWERS,
  layOut: layOutRocks,
};
