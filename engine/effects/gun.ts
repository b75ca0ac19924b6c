import { whereAny } from './count.ts';
import type { Effect } from './effect.ts';
export const gun: Effect = {
  name: 'gun',
  summary: 'held, pulls her to the nearest asteroid: 39 (1 - d / range) px/s2, and turns her towards it',
  calledFor: whereAny('asteroids', 'asteroid'),
};
