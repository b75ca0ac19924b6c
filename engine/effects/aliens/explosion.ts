import type { Effect } from '../effect.ts';
import { explode } from './events.ts';

export const alienExplosion: Effect = {
  name: 'alien-explosion',
  summary: () => 'two aliens that touch explode',
  calledFor: (level) => {
    const n = level.aliens.length;
    return n > 1 ? { called: true, because: `${n} aliens` } : { called: false, because: 'fewer than two aliens' };
  },
  events: [explode],
};
