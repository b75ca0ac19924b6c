import type { Verdict } from '../../schema/index.ts';

/** The meaning of each verdict that needs attention, as the beginning of a sentence. */
export const VERDICT_MEANS: Readonly<Record<Exclude<Verdict, 'completable'>, string>> = {
  broken: 'none of its runs completes the level',
  unproven: 'nothing shows that it can be completed',
  impossible: 'it is proved that nobody can complete it',
  invalid: 'the file is not a valid level',
  crashed: 'gq itself failed on it',
};
