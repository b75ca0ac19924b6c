import type { Effect } from './effect.ts';

export const hotAsteroids: Effect = {
  name: 'hot-asteroids',
  summary: 'burn on touch, and pull like cold ones',
  calledFor: (level) => {
    const n = level.asteroids.filter((a) => a.hot).length;
    return n > 0
      ? { called: true, because: `${n} hot ${n === 1 ? 'asteroid' : 'asteroids'}` }
      : { called: false, because: 'no hot asteroids' };
  },
};
