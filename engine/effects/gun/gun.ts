import { GUN_PULL } from '../../constants.ts';
import { whereAny } from '../count.ts';
import type { Effect } from '../effect.ts';
import { meetTarget, passCentre, switchTarget } from './events.ts';

export const gun: Effect = {
  name: 'gun',
  summary: 'held, pulls her to the nearest asteroid: 39 (1 - d / range) px/s2, and turns her towards it',
  calledFor: whereAny('asteroids', 'asteroid'),
  force: { strongest: () => GUN_PULL, acts: 'instead' },
  events: [passCentre, meetTarget, switchTarget],
};
