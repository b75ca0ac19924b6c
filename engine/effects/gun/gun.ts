import { SLOTS, stir } from '../../motion/index.ts';
import { whereAny } from '../count.ts';
import type { Effect } from '../effect.ts';
import { meetTarget, passCentre, switchTarget } from './events.ts';
import { gunPull } from './force.ts';
import { isTiny, skipOrbits } from './orbits.ts';
import { holdNearest } from './target.ts';
import { turnToTarget } from './turn.ts';

const { HELD, TARGET } = SLOTS;

export const gun: Effect = {
  name: 'gun',
  summary: ({ pull }) =>
    `while held, pulls her towards the nearest asteroid at ${pull} (1 - d / range) px/s2 and turns her towards it`,
  calledFor: whereAny('asteroids', 'asteroid'),
  rules: ['pull'],
  force: gunPull,
  beforePiece(m) {
    if (m.recoil && m.s[HELD] === 1) stir(m, m.s[TARGET]);
  },
  moved: holdNearest,
  turn: turnToTarget,
  repeat: skipOrbits,
  mayRepeat: (m) => isTiny(m, 4),
  events: [passCentre, meetTarget, switchTarget],
};
