import type { StoreApi } from 'zustand/vanilla';
import type { EdgeSlack } from '../../../solver/index.ts';
import type { Desk } from '../../core/ask/index.ts';
import { type Tightest, tightestOf } from '../../core/figures/index.ts';
import { slackQuestion } from '../../core/proof/index.ts';
import type { FormerRun } from './former.ts';

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

/** The part of the robustness of the shown run, as the Solver panel shows it, that is compared. */
export interface ShownSlack {
  readonly phase: 'waiting' | 'measuring' | 'measured' | 'fails' | 'failed';
  readonly message: string | null;
  readonly slack: readonly EdgeSlack[] | null;
  readonly withMinerals: boolean;
}

/** Of the shown run. */
export function shownSlack({ phase, message, slack }: ShownSlack): SlackKnown {
  if (phase === 'fails') return FAILS;
  if (phase === 'failed') return { is: 'unknown', why: message ?? 'the measurement failed' };
  return slack === null ? MEASURING : measured(slack);
}

/** The slack of former runs: known because each was the shown run once, or measured by a worker. */
interface FormerSlack {
  /** Keeps what is known of the shown run. */
  keep(run: FormerRun, known: SlackKnown): void;
  /** What is known; if nothing is, a worker measures it. The latest question wins. */
  ask(run: FormerRun, tell: (known: SlackKnown) => void): SlackKnown;
  forget(): void;
}

/** @param robustness of the shown run: its goal applies to former runs, too */
export function createFormerSlack(desk: Desk, robustness: Pick<StoreApi<ShownSlack>, 'getState'>): FormerSlack {
  const kept = new WeakMap<FormerRun, { readonly known: SlackKnown; readonly withMinerals: boolean }>();
  const slack = slackQuestion(desk, null);
  const keep = (run: FormerRun, known: SlackKnown) => {
    if (known.is !== 'measuring') kept.set(run, { known, withMinerals: robustness.getState().withMinerals });
  };
  return {
    keep,
    forget: slack.forget,
    ask(run, tell) {
      const { end, unknown, taken } = run.figures;
      if (end === null) return { is: 'unknown', why: unknown };
      if (end.outcome !== 'completed' || run.name === null) return FAILS;
      const { withMinerals } = robustness.getState();
      const own = kept.get(run);
      if (own !== undefined && own.withMinerals === withMinerals) return own.known;
      const { phase, of } = slack.store.getState();
      if (phase === 'asking' && of?.of === run) return MEASURING;
      const goal = { minerals: withMinerals ? taken : ('any' as const) };
      slack.ask({ ...run, of: run, goal }, ({ answer, message }) => {
        const known: SlackKnown = answer === null ? { is: 'unknown', why: message ?? '' } : measured(answer);
        keep(run, known);
        tell(known);
      });
      return MEASURING;
    },
  };
}
