import { px } from './numbers.ts';
import type { Finding, Rule, Subject } from './warning.ts';

const RULE_OF_REACH =
  'She is lost farther than the range from the centre of every asteroid, and her box reaches at most 18.9 px beyond her centre. ' +
  'Only asteroids count that she can come to, hopping from range to range. With recoil, the warning allows for how far asteroids can drift in 60 s.';

function* outOfReach(
  { level, reach }: Subject,
  what: string,
  thing: { readonly x: number; readonly y: number; readonly radius: number },
  pointer: string,
): Generator<Finding> {
  const nearest = reach.nearest(thing);
  const limit = reach.limit(thing.radius);
  if (nearest === null || nearest.distance < limit) return;
  const whom = reach.hasIslands ? 'the nearest asteroid she can come to' : 'the nearest asteroid';
  yield {
    message:
      `${what} is out of reach: ${whom}, asteroids[${nearest.index}], is ${px(nearest.distance)} away, ` +
      `and farther than ${px(limit)} she is lost before she touches it (range ${px(level.range)})`,
    hint: `bring ${what} and an asteroid ${px(nearest.distance - limit)} nearer to each other, and more to give the player room, or raise the range`,
    pointer,
  };
}

/** The level can't be completed. */
export const blackHoleOutOfReach: Rule = {
  explanation: {
    code: 'black-hole-out-of-reach',
    severity: 'warning',
    title: 'the black hole is out of reach of every asteroid',
    why: `${RULE_OF_REACH} So nobody can touch this black hole: the level can't be completed.`,
    fix: 'Put an asteroid nearer to the black hole, a stepping stone in the gap before it, or raise the range.',
  },
  find: (subject) => outOfReach(subject, 'the black hole', subject.level.blackHole, '/blackHole'),
};

/** It can't be collected. */
export const mineralOutOfReach: Rule = {
  explanation: {
    code: 'mineral-out-of-reach',
    severity: 'warning',
    title: 'a mineral is out of reach of every asteroid',
    why: `${RULE_OF_REACH} So nobody can collect this mineral.`,
    fix: 'Put the mineral nearer to an asteroid, an asteroid nearer to the mineral, or raise the range.',
  },
  *find(subject) {
    for (const [i, mineral] of subject.level.minerals.entries()) {
      yield* outOfReach(subject, `minerals[${i}]`, mineral, `/minerals/${i}`);
    }
  },
};
