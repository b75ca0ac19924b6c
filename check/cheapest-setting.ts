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
  inHaste,
  measureCosts,
  pathOfRun,
  playerOf,
  type Reference,
  referenceOf,
} from '../engine/work-precision/index.ts';
import type { Hold, Level } from '../schema/index.ts';
import { type EdgeSlack, findSlackInSteps } from '../solver/index.ts';
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
  /** Settings that were not tried, as none was found before the time was used up. */
  readonly untried: readonly Accuracy[];
  /** Runs that have no reference which a second one confirms, and why. */
  readonly doubts: readonly { readonly run: KeptRun; readonly doubt: string }[];
}

interface CheapestOptions {
  readonly terms: Terms;
  readonly methods: readonly Accuracy[];
  /** A clock, ms. */
  readonly now: () => number;
  /** About how long settings are timed, the longest, and the longest that all takes, ms; a play that has begun ends. */
  readonly budget: { readonly timing: number; readonly most: number; readonly all: number };
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
  const end = now() + budget.all;
  const isLate = () => now() > end;
  const wanted: Wanted[] = [];
  for (const run of runs) {
    const known = isLate() ? null : wantedOf(run, terms, isLate);
    if (typeof known === 'object' && known !== null) wanted.push(known);
    else {
      const doubt = known ?? 'the time was used up before it was known what is to be kept of it';
      return { tried: [], cheapest: null, untried: methods, doubts: [{ run, doubt }] };
    }
  }
  const doubts = wanted.flatMap(({ run, reference: { doubt } }) => (doubt === null ? [] : [{ run, doubt }]));
  const inOrder = [...methods].sort(inHaste);
  const costs = measureCosts(
    inOrder.map((accuracy) => playerOf(runs, accuracy, maxTicks)),
    now,
    { budget: budget.timing, most: budget.most, sample: SAMPLE },
  );
  const byCost = inOrder
    .flatMap((accuracy, i) => (costs[i] === null ? [] : [{ accuracy, cost: costs[i] }]))
    .sort((a, b) => a.cost.minimum - b.cost.minimum);
  const tried: TriedSetting[] = [];
  for (const { accuracy, cost } of byCost) {
    const result = isLate() ? null : tryAt(wanted, accuracy, terms, isLate);
    if (result === null) break;
    const setting = { accuracy, cost, ...result };
    tried.push(setting);
    if (setting.broken === null) return { tried, cheapest: setting, untried: [], doubts };
  }
  const untried = methods.filter((method) => tried.every(({ accuracy }) => accuracy !== method));
  return { tried, cheapest: null, untried, doubts };
}

/** What is to be kept of a run; in words why that is not known, or null if the time is used up. */
function wantedOf(run: KeptRun, terms: Terms, isLate: () => boolean): Wanted | string | null {
  const exact = playAt(run, ACCURACIES.precise, terms);
  if (exact === null)
    return `it takes more than ${terms.maxWork} pieces of motion at precise, so nothing can be compared with it`;
  const reference = referenceOf(run.level, run.holds, maxTicksOf(terms), terms.maxWork);
  const slack = exact.outcome === 'completed' ? slackAt(run, exact, ACCURACIES.precise, terms, isLate) : [];
  return slack && { run, reference, minerals: collected(exact), slack };
}

/** Whether a setting keeps runs; the dearest question, that of slack, comes last. null: the time is used up. */
function tryAt(
  wanted: readonly Wanted[],
  accuracy: Accuracy,
  terms: Terms,
  isLate: () => boolean,
): Omit<TriedSetting, 'accuracy' | 'cost'> | null {
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
    const own = slackAt(run, as, accuracy, terms, isLate);
    if (own === null) return null;
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

/** How far each press and release may move while she completes the level with as many minerals; null if the time is used up. */
function slackAt({ level, holds }: KeptRun, run: Run, accuracy: Accuracy, terms: Terms, isLate: () => boolean) {
  const steps = findSlackInSteps(compile(level, { ...terms, accuracy }), holds, { minerals: countMinerals(run) });
  for (let step = steps.next(); ; step = steps.next()) {
    if (step.done === true) return step.value;
    if (isLate()) return null;
  }
}
