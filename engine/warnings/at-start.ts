import { objectName } from '../../schema/basics/index.ts';
import { boxCircleGap, boxOverlapsCircle } from '../contact.ts';
import { distance, px } from './bodies.ts';
import type { Rule } from './warning.ts';

/** She starts inside a hazard, so the run ends at once. */
export const startsInHazard: Rule = {
  explanation: {
    code: 'starts-in-hazard',
    severity: 'warning',
    title: 'the astronaut starts inside a hazard',
    why: 'Her collision box, upright at the start, overlaps a nova, a hot asteroid or an alien. Every run ends as it begins, whatever the player does.',
    fix: 'Move the astronaut or the hazard until her box is clear of it, with some room to turn: a press turns the box, and its corners are half its diagonal, 18.9 px, from its centre.',
  },
  *find({ level, box, bodies }) {
    const { x, y } = level.astronaut;
    for (const body of bodies) {
      if (!body.isHazard || !boxOverlapsCircle(box, body.x - x, body.y - y, 1, 0, body.radius)) continue;
      const depth = -boxCircleGap(box, body.x - x, body.y - y, 1, 0, body.radius);
      yield {
        message: `the astronaut starts inside ${body.name}: her box reaches ${px(depth)} into its radius of ${px(body.radius)}`,
        hint: `move the astronaut and ${body.name} apart by at least ${px(depth)}`,
        pointer: '/astronaut',
      };
    }
  },
};

/** She starts at the black hole, so there is nothing to play. */
export const touchesBlackHoleAtStart: Rule = {
  explanation: {
    code: 'touches-black-hole-at-start',
    severity: 'warning',
    title: 'the level is completed as it begins',
    why: 'At the start her collision box touches the black hole. Touching it completes the level, so there is nothing to play.',
    fix: 'Move the astronaut or the black hole until there is some distance between them.',
  },
  *find({ level, box }) {
    const { astronaut, blackHole } = level;
    const dx = blackHole.x - astronaut.x;
    const dy = blackHole.y - astronaut.y;
    if (!boxOverlapsCircle(box, dx, dy, 1, 0, blackHole.radius)) return;
    const depth = px(-boxCircleGap(box, dx, dy, 1, 0, blackHole.radius));
    yield {
      message: `the astronaut starts inside the black hole: her box reaches ${depth} into its radius of ${px(blackHole.radius)}`,
      hint: 'move the astronaut or the black hole away',
      pointer: '/astronaut',
    };
  },
};

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
