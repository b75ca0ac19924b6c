import { createStore, type StoreApi } from 'zustand/vanilla';
import { ofDocument } from '../../core/kept/index.ts';
import type { FormerRun } from './former.ts';
import { MEASURING, type SlackKnown } from './slack.ts';

/** What the page compares the shown run with. */
export interface Comparison {
  /** null: nothing is compared. */
  readonly former: FormerRun | null;
  /** `held`: the change is in progress. `ended`: it has just ended. `asked`: by the command. */
  readonly phase: 'held' | 'ended' | 'asked';
  /** The slack of the former run. */
  readonly slack: SlackKnown;
  /** The slack of the shown run. */
  readonly slackNow: SlackKnown;
  /** The differences when the last change ended, for a screen reader. */
  readonly said: string;
}

export type OnionStore = StoreApi<Comparison>;

/** What the shown run of a level is compared with. */
export const onionOf = ofDocument(() =>
  createStore<Comparison>(() => ({ former: null, phase: 'ended', slack: MEASURING, slackNow: MEASURING, said: '' })),
);
