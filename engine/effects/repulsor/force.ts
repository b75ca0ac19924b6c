import { type CentralForce, rebase, SLOTS } from '../../motion/index.ts';

const { FIELD } = SLOTS;

/** The push of a field away from its centre, equally strong everywhere in it. */
export const repulsorPush: CentralForce = {
  acts: 'instead',
  strongest: (_level, { push }) => push,
  isActing: ({ s }) => s[FIELD] >= 0,
  centre(m) {
    const { x, y } = m.scene.repulsors;
    const field = m.s[FIELD];
    rebase(m, -1, x[field] - m.originX, y[field] - m.originY, 0, 0);
  },
  set({ flow, rules }) {
    flow.alpha = rules.push;
    flow.beta = 0;
    flow.range = 0;
    flow.extra = rules.push;
  },
  swing: () => Number.POSITIVE_INFINITY,
};
