import {
  CENTRAL,
  type CentralForce,
  LINEAR,
  layOutRocks,
  type Motion,
  RECORDS,
  rebase,
  SLOTS,
  stir,
  TURNS,
} from '../../motion/index.ts';
import { type Effect, whereAny } from '../effect.ts';
import { meetTarget, passCentre, switchTarget } from './events.ts';
import { holdOnLine } from './line.ts';
import { isTiny, skipOrbits } from './orbits.ts';
import { holdNearest } from './target.ts';

export { recordTarget } from './target.ts';

const { HELD, TARGET, FIELD, KIND, TURN, COS, SIN, SIDE, LINE_X, LINE_Y } = SLOTS;
const { ROCK } = RECORDS;
const { TURN_TO_BASE, TURN_TO_TARGET } = TURNS;

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
  layOut: layOutRocks,
};
