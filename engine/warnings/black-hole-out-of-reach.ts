import { objectName } from '../../schema/basics/index.ts';
import { px } from './bodies.ts';
import type { Finding, Rule, Subject } from './warning.ts';

/** The reasoning that both explanations share. */
export const RULE_OF_REACH =
  'She is lost when she is farther than the range from the centre of every asteroid, and her collision box reaches at most 18.9 px beyond her centre. ' +
  'Only asteroids that she can reach count, going from the range of one into the range of the next. In a level with recoil the warning allows for how far asteroids can drift within the longest run.';

/** Yields a finding if an object cannot be touched. */
export function* outOfReach(
  { level, reach }: Subject,
  what: string,
  thing: { readonly x: number; readonly y: number; readonly radius: number },
  pointer: string,
): Generator<Finding> {
  const nearest = reach.nearest(thing);
  const limit = reach.limit(thing.radius);
  if (nearest === null || nearest.distance < limit) return;
  const whom = reach.hasIslands ? 'the nearest asteroid she can reach' : 'the nearest asteroid';
  yield {
    message:
      `${what} is out of reach: ${whom}, ${objectName('asteroid', nearest.index)}, is ${px(nearest.distance)} away, ` +
      `and beyond ${px(limit)} she is lost before she touches it (range ${px(level.range)})`,
    hint: `bring ${what} and an asteroid at least ${px(nearest.distance - limit)} nearer to each other (more gives the player room), or raise the range`,
    pointer,
  };
}

/** The black hole is too far from every asteroid, so the level cannot be completed. */
export const blackHoleOutOfReach: Rule = {
  explanation: {
    code: 'black-hole-out-of-reach',
    severity: 'warning',
    title: 'the black hole is out of reach of every asteroid',
    why: `${RULE_OF_REACH} So nobody can touch this black hole, and the level cannot be completed.`,
    fix: 'Put an asteroid nearer to the black hole, put one into the gap before it, or raise the range.',
  },
  find: (subject) => outOfReach(subject, 'the black hole', subject.level.blackHole, '/blackHole'),
};
