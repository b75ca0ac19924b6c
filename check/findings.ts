import type { Run, Warning, WorkBudget } from '../engine/index.ts';
import type { Allowed, Hold, Level, Verdict } from '../schema/index.ts';
import { type Closest, type Effort, LIVES_ON, type LostPlace, type Proof, type SoftlockSurvey } from '../solver/index.ts';
import type { AccuracyHang } from './accuracy-hangs.ts';
import type { TightRun } from './certified-ticks.ts';
import type { LostMineral } from './proofs.ts';
import type { RunEnd } from './words/index.ts';

/** How one of the level's own runs ended. */
export interface ScriptEnd extends RunEnd {
  /** Name of the run. */
  readonly name: string;
  /** True when the run exceeded the work limit and was not simulated beyond `time`. */
  readonly isStopped: boolean;
}

/** How runs of a level ended, as plain data. @param scripts the level's runs @param runs the same, simulated */
export const scriptEnds = (scripts: Level['runs'], runs: readonly Run[]): ScriptEnd[] =>
  runs.map(({ outcome, with: touched, time, tick, stopped }, i) => ({
    name: scripts[i].name,
    outcome,
    with: touched,
    time,
    tick,
    isStopped: stopped !== null,
  }));

/** A limit that was exceeded. */
export interface Overrun {
  /** The work that was allowed, pieces of motion. */
  readonly maxWork: number;
  /** What was exceeded. */
  readonly of: 'work' | 'memory';
}

/** Describes how a budget was exceeded. */
export const overrunOf = ({ maxWork, spent }: Pick<WorkBudget, 'maxWork' | 'spent'>): Overrun => ({
  maxWork,
  of: spent >= maxWork ? 'work' : 'memory',
});

/** How a level's runs ended and what looks wrong in it. This is plain data that a worker can send. */
export interface RunFindings {
  /** Name of the accuracy at which the runs were simulated. */
  readonly accuracy: string;
  /** Range of the level, px. */
  readonly range: number;
  /** How each run ended, in the order of the level's list. */
  readonly ends: readonly ScriptEnd[];
  /** Indices of the minerals that some run collects, from 0. */
  readonly collected: readonly number[];
  /** Runs that complete the level at some accuracies but not at others. */
  readonly hangs: readonly AccuracyHang[];
  /** The problems that the level allows, by code. */
  readonly allow: Allowed;
  /** The warnings, in the order of `findWarnings`. */
  readonly warnings: readonly Warning[];
  /** What was left out because it would have exceeded the work limit; null where nothing was. */
  readonly cuts: {
    /** Some runs were not simulated to their end. */
    readonly runs: Overrun | null;
    /** The runs were not compared at other accuracies. */
    readonly accuracies: Overrun | null;
    /** What the runs come near to was not examined. */
    readonly nearness: Overrun | null;
  };
}

/** The result of a search for a run. */
export interface Searched {
  /** The holds of a run that completes the level, confirmed by a replay; null when none was found. */
  readonly found: readonly Hold[] | null;
  /** The work that the search has done. */
  readonly effort: Effort;
  /** The closest approach; null when nothing was simulated. */
  readonly closest: Closest | null;
}

/** Findings beyond the level's own runs. */
export interface MoreFindings {
  /** A proof that nobody can complete the level; null when there is none. */
  readonly impossible: Proof | null;
  /** The minerals that are proved to be out of reach. */
  readonly lost: readonly LostMineral[];
  /** The result of a search for a run; null when there was no search. */
  readonly searched: Searched | null;
  /** Runs with fewer certified ticks than required; empty when nothing was required. */
  readonly tight: readonly TightRun[];
  /** Where it is already lost although she lives on; null when nothing was looked for. */
  readonly softlocks: Softlocks | null;
  readonly sought: Sought;
}

/** What was looked for beyond the level's own runs. Where nothing was looked for, nothing is known. */
interface Sought {
  /** The slack of the runs: `low`, whether there is any; `required`, whether it is as required; null, nothing. */
  readonly slack: 'low' | 'required' | null;
  /** Whether minerals were to be proved out of reach. */
  readonly minerals: boolean;
  /** Whether places were looked for at which the level is already lost. */
  readonly softlocks: boolean;
}

/** Everything that a check finds out about a level, before it is put into words. */
export interface Findings extends RunFindings, MoreFindings {}

/** The findings when nothing was proved, searched for or certified. */
export const unproved: MoreFindings = {
  impossible: null,
  lost: [],
  searched: null,
  tight: [],
  softlocks: null,
  sought: { slack: null, minerals: false, softlocks: false },
};

/**
 * Combines findings.
 * @param runs what the runs showed
 * @param more what else was found; missing properties are taken from {@link unproved}
 * @returns all findings
 */
export const findingsOf = (runs: RunFindings, more: Partial<MoreFindings>): Findings => Object.assign({}, runs, unproved, more);

/** Whether one of the level's own runs completes it. */
export const completesItself = ({ ends }: Pick<RunFindings, 'ends'>): boolean =>
  ends.some(({ outcome }) => outcome === 'completed');

/** The verdict on a level that could be read and checked. */
export type LevelVerdict = Exclude<Verdict, 'invalid' | 'crashed'>;

/**
 * Decides the verdict from findings. A completing run outweighs a proof. A run that was not simulated to its end may still
 * complete the level, so such a level is `unproven` and not `broken`.
 * @param findings how the runs ended, and the results of the search and of the provers
 * @returns the verdict
 */
export function verdictOfFindings(findings: Pick<Findings, 'ends' | 'impossible' | 'searched'>): LevelVerdict {
  const { ends, impossible, searched } = findings;
  if (completesItself(findings) || (searched !== null && searched.found !== null)) return 'completable';
  if (impossible !== null) return 'impossible';
  return ends.length > 0 && ends.every(({ isStopped }) => !isStopped) ? 'broken' : 'unproven';
}

/**
 * Updates a verdict that was given before proofs were sought.
 * @param verdict the verdict without proofs
 * @param isImpossible whether it is proved that nobody can complete the level
 * @returns the final verdict
 */
export const onceProved = (verdict: LevelVerdict, isImpossible: boolean): LevelVerdict =>
  isImpossible && verdict !== 'completable' ? 'impossible' : verdict;

/** What a survey found about states in which it is already lost. Plain data. */
export interface Softlocks {
  /** How many states were examined, and what is known of how many of them. */
  readonly states: {
    readonly examined: number;
    readonly open: number;
    readonly proved: number;
    readonly notFound: number;
    readonly unknown: number;
  };
  /** Of these the lost ones after which she was seen alive for a second and more. */
  readonly lasting: { readonly proved: number; readonly notFound: number };
  /** Where such states begin, the longest life first. */
  readonly places: readonly LostPlace[];
  readonly effort: { readonly runs: number; readonly ticks: number };
  readonly isFinished: boolean;
}

/** The findings of a survey, finished or not. */
export function softlocksOf(survey: SoftlockSurvey): Softlocks {
  const { states } = survey;
  const count = (is: string, alive = 0): number =>
    states.filter((state) => state.standing.is === is && state.alive >= alive).length;
  return {
    states: {
      examined: states.length,
      open: count('open'),
      proved: count('proved'),
      notFound: count('not found'),
      unknown: count('unknown'),
    },
    lasting: { proved: count('proved', LIVES_ON), notFound: count('not found', LIVES_ON) },
    places: survey.places,
    effort: { ...survey.effort },
    isFinished: survey.finished,
  };
}
