import { objectName } from '../../schema/index.ts';
import { distance, px } from './geometry.ts';
import type { Rule } from './warning.ts';

/** No asteroid is in range at the start, so she is lost at once. */
export const nothingInRangeAtStart: Rule = {
  explanation: {
    code: 'nothing-in-range-at-start',
    severity: 'warning',
    title: 'no asteroid is within range at the start',
    why: 'Farther than the range from the centre of every asteroid she is lost. Here that is so at the very start: every run ends at once.',
    fix: 'Start her nearer to an asteroid, put an asteroid nearer to her, or give the level a larger `range`.',
  },
  *find({ level }) {
    const { astronaut, asteroids, range } = level;
    if (asteroids.length === 0) {
      yield {
        message: 'the level has no asteroid, so that the astronaut is lost at the start',
        hint: `put an asteroid within ${px(range)} of the astronaut`,
        pointer: '/astronaut',
      };
      return;
    }
    let nearest = 0;
    let least = Number.POSITIVE_INFINITY;
    for (const [i, asteroid] of asteroids.entries()) {
      const d = distance(asteroid, astronaut);
      if (d >= least) continue;
      nearest = i;
      least = d;
    }
    if (least <= range) return;
    yield {
      message: `the astronaut is lost at the start: the nearest asteroid, ${objectName('asteroid', nearest)}, is ${px(least)} away, the range is ${px(range)}`,
      hint: `bring one of them ${px(least - range)} nearer, or raise range to ${px(least)} or more`,
      pointer: '/astronaut',
    };
  },
};
