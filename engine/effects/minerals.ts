import type { Effect } from './effect.ts';

import { whereAny } from './count.ts';
export const minerals: Effect = {
  name: 'minerals',
  summary: 'collected on touch',
  calledFor: whereAny('minerals', 'mineral'),
};
