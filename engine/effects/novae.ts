import { whereAny } from './count.ts';
import type { Effect } from './effect.ts';
export const novae: Effect = {
  name: 'novae',
  summary: 'burn on touch',
  calledFor: whereAny('novae', 'nova'),
};
