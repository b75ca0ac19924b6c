import { type CentralForce, type Motion, RECORDS, rebase, SLOTS } from '../../motion/index.ts';

const { HELD, TARGET } = SLOTS;
const { ROCK } = RECORDS;

/** The pull of the gun towards its target: pull (1 - d / range). */
export const gunPull: CentralForce = {
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
