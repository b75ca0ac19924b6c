import type { StoreApi } from 'zustand/vanilla';
import type { RunEnd } from '../../../check/words/index.ts';
import type { Box, Terms } from '../../../engine/index.ts';
import type { Hold, Level, LevelFile } from '../../../schema/index.ts';
import type { EdgeSlack } from '../../../solver/index.ts';
import type { Desk } from '../../core/ask/index.ts';
import { type Tightest, tightestOf } from '../../core/figures/index.ts';
import {
  createProver,
  endInWords,
  isWhole,
  type LiveProof,
  type NearMiss,
  pathOf,
  playsAlike,
  slackQuestion,
} from '../../core/proof/index.ts';

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

/** The shown run as it was before a change: copied, as the arrays of a proof are overwritten by the next one. */
export interface FormerRun {
  readonly file: LevelFile;
  readonly level: Level;
  /** Under which it was played. */
  readonly terms: Terms;
  /** The astronaut's collision box. */
  readonly her: Box;
  /** null: the level had no run, she drifted */
  readonly name: string | null;
  readonly holds: readonly Hold[];
  readonly figures: Figures;
  /** x, y in px, two entries per tick, and those at the end */
  readonly points: Float32Array;
}

/** Copies the shown run. */
export function formerOf(proof: LiveProof): FormerRun {
  const { file, level, terms, scene, run } = proof;
  const { name, holds, way } = run;
  return { file, level, terms, her: scene.box, name, holds, figures: figuresOf(proof), points: pathOf(way) };
}

/** Whether it is the run that is shown now, under the same terms. */
export const isShown = ({ name, terms }: FormerRun, now: Pick<LiveProof, 'run' | 'terms'>): boolean =>
  name === now.run.name && terms === now.terms;

/** Whether nothing is different that the run depends on: only a name, say. */
export const playsLike = (former: FormerRun, now: LiveProof): boolean =>
  playsAlike(former, now) && former.holds.join() === now.run.holds.join();

// what is compared of a run

/** What is known of a run, to compare it with another. */
export interface Figures {
  /** How it ends; null: it was not simulated to its end. */
  readonly end: RunEnd | null;
  /** Range of the level, px. */
  readonly range: number;
  /** Why the end is not known, in words; '' if it is. */
  readonly unknown: string;
  /** How many minerals it collects, and how many there are. */
  readonly taken: number;
  readonly minerals: number;
  /** Where she is nearest to a hazard at any tick, as in the inspector; null: the level has none. */
  readonly closest: NearMiss | null;
}

/** The figures of the shown run. The distances are computed, so its arrays must still be valid. */
export function figuresOf(proof: LiveProof): Figures {
  const { run, level } = proof;
  const { outcome, with: touched, time, tick } = run;
  const isKnown = isWhole(proof);
  return {
    end: isKnown ? { outcome, with: touched, time, tick } : null,
    range: level.range,
    unknown: isKnown ? '' : endInWords(proof),
    taken: run.minerals.length,
    minerals: level.minerals.length,
    closest: isKnown ? proof.margins.closest : null,
  };
}

/** ms that the page may be blocked by it */
const PATIENCE = 400;

/**
 * The run that is shown now, as it was in a former level. It is played again if another run was shown then, or under
 * other terms.
 */
export function replayFormer(former: FormerRun, now: LiveProof): FormerRun {
  if (isShown(former, now)) return former;
  const { file, level } = former;
  const proof = createProver().prove({
    file,
    run: now.run.name,
    // the level has the rules of the folder that applied then
    terms: { ...now.terms, rules: level.rules ?? {} },
    patience: PATIENCE,
  });
  return formerOf(proof);
}
