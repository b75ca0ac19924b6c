import { createProver } from '../../proof/index.ts';
import type { Start } from '../work.ts';

/** All that the page shows of a level, with every run played to its end: for levels that would keep the page too busy. */
export const check: Start<'check'> = function* ({ file, accuracy }) {
  yield null;
  const { verdict, provenBy, problems } = createProver().prove({ file, run: null, accuracy });
  return { verdict, provenBy, problems };
};
