import { compile } from '../../../engine/index.ts';
import type { Start } from '../work.ts';
import { follow } from './follow.ts';

/** Follows her tick by tick. */
export const path: Start<'path'> = function* ({ level, terms, holds, until }) {
  const { points } = yield* follow(compile(level, terms), holds, until);
  return { points };
};
