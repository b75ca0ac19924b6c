import type { Effect } from '../effect.ts';
import { freeAxis, holdAxis, limitStart } from './events.ts';

export const speedLimit: Effect = {
  name: 'speed-limit',
  summary: (rules) => `each component of a velocity stays within ${rules.speedLimit} px/s`,
  calledFor: () => ({ called: true, because: 'a long run may reach it' }),
  rules: ['speedLimit'],
  events: [holdAxis, freeAxis],
  layOut: limitStart,
};
