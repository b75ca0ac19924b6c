import { whereAny } from './count.ts';
import type { Effect } from './effect.ts';
export const repulsor: Effect = {
  name: 'repulsor',
  summary: 'pushes her away at 20 px/s2 while her centre is inside, instead of the gun',
  calledFor: whereAny('repulsors', 'repulsor'),
};
