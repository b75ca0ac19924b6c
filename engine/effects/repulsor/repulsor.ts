import { REPULSOR_PUSH } from '../../constants.ts';
import { whereAny } from '../count.ts';
import type { Effect } from '../effect.ts';
import { enterFields } from './fields.ts';
import { comeOffRim, enterField, leaveField } from './rims.ts';

export const repulsor: Effect = {
  name: 'repulsor',
  summary: 'pushes her away at 20 px/s2 while her centre is inside, instead of the gun',
  calledFor: whereAny('repulsors', 'repulsor'),
  force: { strongest: () => REPULSOR_PUSH, acts: 'instead' },
  events: [enterField, leaveField, comeOffRim],
  layOut: enterFields,
};
