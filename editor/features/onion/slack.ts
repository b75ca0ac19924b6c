import type { EdgeSlack } from '../../../solver/index.ts';
import { type Tightest, tightestOf } from '../../core/figures/index.ts';

/** The slack of a run, as far as it is known. */
export type SlackKnown =
  /** it is being measured */
  | { readonly is: 'measuring' }
  /** `tightest`: null for a run without holds, which can't be mistimed */
  | { readonly is: 'measured'; readonly tightest: Tightest | null }
  /** the run does not complete the level */
  | { readonly is: 'fails' }
  | { readonly is: 'unknown'; readonly why: string };

export const MEASURING: SlackKnown = { is: 'measuring' };
export const FAILS: SlackKnown = { is: 'fails' };

/** @param slack of each press and release */
export const measured = (slack: readonly EdgeSlack[]): SlackKnown => ({ is: 'measured', tightest: tightestOf(slack) });
