import { layOutRocks } from '../../motion/index.ts';
import type { Effect } from '../effect.ts';

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
