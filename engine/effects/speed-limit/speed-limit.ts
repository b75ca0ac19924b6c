import { SPEED_LIMIT } from '../../constants.ts';
import type { Effect } from '../effect.ts';
import { freeAxis, holdAxis, limitStart } from './events.ts';

export const speedLimit: Effect = {
  name: 'speed-limit',
  summary: `each component of a velocity stays within ${SPEED_LIMIT} px/s`,
  calledFor: () => ({ called: true, because: 'a long run may reach it' }),
  events: [holdAxis, freeAxis],
  layOut: limitStart,
};
