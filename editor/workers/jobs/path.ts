import { compile } from '../../../engine/index.ts';
import type { Start } from '../work.ts';
import { follow } from './follow.ts';

/** Follows her tick by tick. */
export const path: Start<'path'> = function* ({ level, accuracy, holds, until }) {
  const { points } = yield* follow(compile(level, accuracy), holds, until);
  return { points };
};
