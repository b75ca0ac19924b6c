import {
  ACCURACIES,
  type Accuracy,
  compile,
  maxTicksOf,
  type Run,
  simulate,
  type Terms,
  WorkBudget,
  WorkLimitReached,
} from '../engine/index.ts';
import {
  type Cost,
  deviationOf,
  measureCosts,
  pathOfRun,
  playerOf,
  type Reference,
  referenceOf,
} from '../engine/work-precision/index.ts';
import type { Hold, Level } from '../schema/index.ts';
import { type EdgeSlack, findSlack } from '../solver/index.ts';
import { countMinerals } from './words/index.ts';

/** A run that a setting has to keep as it is. */
export interface KeptRun {
  readonly file: string;
  readonly name: string;
  readonly level: Level;
  readonly holds: readonly Hold[];
}

/** What a setting does to runs. */
export interface TriedSetting {
  readonly accuracy: Accuracy;
  readonly cost: Cost;
  /** The first run that is not kept, and what is different; null: all are. */
  readonly broken: { readonly run: KeptRun; readonly what: string } | null;
  /**
   * The largest error, px, and the largest share of a run's clearance that its error takes, each with its run. Null where a run is
   * not kept; `tightest` also where nothing deadly is near any run.
   */
  readonly error: { readonly px: number; readonly run: KeptRun; readonly knownTo: number | null } | null;
  readonly tightest: { readonly share: number; readonly run: KeptRun } | null;
}

export interface CheapestSetting {
  /** From the cheapest on; the last one keeps all runs, unless none does. */
  readonly tried: readonly TriedSetting[];
  readonly cheapest: TriedSetting | null;
  /** Runs that have no reference which a second one confirms, and why. */
  readonly doubts: readonly { readonly run: KeptRun; readonly doubt: string }[];
}

interface CheapestOptions {
  readonly terms: Terms;
  readonly methods: readonly Accuracy[];
  /** A clock, ms. */
  readonly now: () => number;
  /** Approximate time for timing, ms. */
  readonly budget: number;
}

/** A run as it has to stay. */
interface Wanted {
  readonly run: KeptRun;
  readonly reference: Reference;
  readonly minerals: string;
  readonly slack: readonly EdgeSlack[];
}

const SAMPLE = 1;

/**
 * Finds the cheapest setting at which every run keeps its outcome, the minerals that it collects, and the slack of each press and
 * release. The outcome is that of the reference with 32 digits, minerals and slack are those at `precise`.
 * @param runs at least one
 */
export function findCheapestSetting(runs: readonly KeptRun[], options: CheapestOptions): CheapestSetting {
  const { terms, methods, now, budget } = options;
  const maxTicks = maxTicksOf(terms);
  const wanted: Wanted[] = [];
  for (const run of runs) {
    const exact = playAt(run, ACCURACIES.precise, terms);
    const doubt = `it takes more than ${terms.maxWork} pieces of motion at precise, so nothing can be compared with it`;
    if (exact === null) return { tried: [], cheapest: null, doubts: [{ run, doubt }] };
    wanted.push({
      run,
      reference: referenceOf(run.level, run.holds, maxTicks, terms.maxWork),
      minerals: collected(exact),
      slack: exact.outcome === 'completed' ? slackAt(run, exact, ACCURACIES.precise, terms) : [],
    });
  }
  const doubts = wanted.flatMap(({ run, reference: { doubt } }) => (doubt === null ? [] : [{ run, doubt }]));
  const costs = measureCosts(
    methods.map((accuracy) => playerOf(runs, accuracy, maxTicks)),
    now,
    { budget, sample: SAMPLE },
  );
  const byCost = methods.map((accuracy, i) => ({ accuracy, cost: costs[i] })).sort((a, b) => a.cost.minimum - b.cost.minimum);
  const tried: TriedSetting[] = [];
  for (const { accuracy, cost } of byCost) {
    const setting = { accuracy, cost, ...tryAt(wanted, accuracy, terms) };
    tried.push(setting);
    if (setting.broken === null) return { tried, cheapest: setting, doubts };
  }
  return { tried, cheapest: null, doubts };
}

/** Whether a setting keeps runs; the dearest question, that of slack, comes last. */
function tryAt(wanted: readonly Wanted[], accuracy: Accuracy, terms: Terms): Omit<TriedSetting, 'accuracy' | 'cost'> {
  let error: TriedSetting['error'] = null;
  let tightest: TriedSetting['tightest'] = null;
  const played: (Wanted & { readonly as: Run })[] = [];
  const broken = (run: KeptRun, what: string) => ({ broken: { run, what }, error: null, tightest: null });
  for (const one of wanted) {
    const { run, reference, minerals } = one;
    const as = playAt(run, accuracy, terms);
    if (as === null) return broken(run, `takes more than ${terms.maxWork} pieces of motion`);
    if (as.outcome !== reference.outcome) return broken(run, `${as.outcome}, not ${reference.outcome}`);
    if (collected(as) !== minerals) return broken(run, `collects minerals ${collected(as) || 'none'}, not ${minerals || 'none'}`);
    played.push({ ...one, as });
    const { error: px } = deviationOf(pathOfRun(as, compile(run.level, { ...terms, accuracy })), reference, maxTicksOf(terms));
    if (error === null || px > error.px) error = { px, run, knownTo: reference.knownTo };
    if (as.clearance === null) continue;
    const share = px / Math.max(as.clearance.distance, Number.MIN_VALUE);
    if (tightest === null || share > tightest.share) tightest = { share, run };
  }
  for (const { run, as, slack } of played) {
    if (as.outcome !== 'completed') continue;
    const own = slackAt(run, as, accuracy, terms);
    const edge = own.findIndex(({ earlier, later }, i) => earlier !== slack[i]?.earlier || later !== slack[i].later);
    if (edge < 0) continue;
    const text = ({ earlier, later }: EdgeSlack) => `${earlier} ticks earlier and ${later} later`;
    const what = `${edge % 2 === 0 ? 'press' : 'release'} ${(edge >> 1) + 1} may come ${text(own[edge])}, not ${text(slack[edge] ?? NONE)}`;
    return broken(run, what);
  }
  return { broken: null, error, tightest };
}

const NONE: EdgeSlack = { earlier: 0, later: 0 };

/** A run at an accuracy; null if it takes more work than the terms allow. */
function playAt({ level, holds }: KeptRun, accuracy: Accuracy, terms: Terms): Run | null {
  try {
    const run = simulate(compile(level, { ...terms, accuracy }), holds, { budget: new WorkBudget(terms.maxWork) });
    return run.stopped === null ? run : null;
  } catch (error) {
    if (error instanceof WorkLimitReached) return null;
    throw error;
  }
}

/** Numbers of the minerals that a run collects, from 1. */
const collected = ({ minerals }: Run): string =>
  [...new Set(minerals.map(({ index }) => index + 1))].sort((a, b) => a - b).join(', ');

/** How far each press and release may move while she completes the level with as many minerals. */
function slackAt({ level, holds }: KeptRun, run: Run, accuracy: Accuracy, terms: Terms): EdgeSlack[] {
  return findSlack(compile(level, { ...terms, accuracy }), holds, { minerals: countMinerals(run) });
}
