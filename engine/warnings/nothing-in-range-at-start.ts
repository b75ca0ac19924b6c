import { objectName } from '../../schema/basics/index.ts';
import { distance, px } from './geometry.ts';
import type { Rule } from './warning.ts';

/** No asteroid is in range at the start, so she is lost at once. */
export const nothingInRangeAtStart: Rule = {
  explanation: {
    code: 'nothing-in-range-at-start',
    severity: 'warning',
    title: 'no asteroid is in range at the start',
    why: 'She is lost when she is farther than the range from the centre of every asteroid. In this level that is so at the start: every run ends as it begins.',
    fix: 'Move the astronaut and an asteroid nearer to each other, or give the level a larger `range`.',
  },
  *find({ level }) {
    const { astronaut, asteroids, range } = level;
    if (asteroids.length === 0) {
      yield {
        message: 'the astronaut is lost at the start: the level has no asteroid',
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
      hint: `move an asteroid and the astronaut ${px(least - range)} nearer to each other, or raise the range to ${px(least)} or more`,
      pointer: '/astronaut',
    };
  },
};
