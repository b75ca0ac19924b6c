import type { Effect } from './effect.ts';

import { whereAny } from './count.ts';
export const novae: Effect = {
  name: 'novae',
  summary: 'burn on touch',
  calledFor: whereAny('novae', 'nova'),
};
