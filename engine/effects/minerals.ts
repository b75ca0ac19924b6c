import { whereAny } from './count.ts';
import type { Effect } from './effect.ts';
export const minerals: Effect = {
  name: 'minerals',
  summary: 'collected on touch',
  calledFor: whereAny('minerals', 'mineral'),
};
