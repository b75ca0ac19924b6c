import { proveGoalImpossible } from '../../check/index.ts';
import { termsReport } from '../../check/words/index.ts';
import { compile, type Scene, simulate, WorkBudget, WorkLimitReached } from '../../engine/index.ts';
import {
  type Hold,
  type Level,
  type OwnRules,
  RULES,
  type RuleName,
  readLevel,
  rulesOf,
  type ScriptedRun,
} from '../../schema/index.ts';
import { nameOfFile, readBytes } from '../io/index.ts';
import { decideWithin } from '../levels/index.ts';
import { showProblems } from '../report-parts/index.ts';
import { Failure } from '../terminal/index.ts';
import { amountsOf, type RuleValue } from './rule-options.ts';
import type { RuleInterval, TunedLevel, TunedValue, TuneSettings, TuneTask } from './tuned-level.ts';

/** The shares of a level's value at which a rule is tried without a sweep: from half to twice. */
const TRIED = Array.from({ length: 31 }, (_, i) => 0.5 + i / 20);

/** Thrown for a value that is not allowed for a rule of this level. */
class OutOfRange extends Error {}

/** Finds the effects of changed rules on one level file. Throws only if gq itself fails. */
export function tuneLevel({ file, settings }: TuneTask): TunedLevel {
  const name = nameOfFile(file);
  const { terms } = settings;
  const under = termsReport({ terms, level: terms });
  const nothing = {
    file,
    name,
    terms: under,
    run: null,
    values: [],
    intervals: [],
    room: null,
    problems: [],
    why: '',
    code: 0,
  } as const;
  try {
    const read = readLevel(readBytes(file), terms);
    if (!read.ok) return { ...nothing, problems: showProblems(read.problems, read.text), why: 'not a valid level', code: 1 };
    const { level } = read;
    return { ...nothing, name: level.name, terms: termsReport({ terms, level }), ...tune(level, settings) };
  } catch (error) {
    if (error instanceof Failure) return { ...nothing, why: error.message, code: 2 };
    if (error instanceof OutOfRange) return { ...nothing, why: `${file}: ${error.message}`, code: 2 };
    throw error;
  }
}

type Tuned = Pick<TunedLevel, 'run' | 'values' | 'intervals' | 'room'>;

function tune(level: Level, settings: TuneSettings): Tuned {
  const { sweep, changes } = settings;
  const own = rulesOf(level);
  const base = firstThatCompletes(level, {}, settings);
  const changed = Object.fromEntries(changes.map((change) => [change.rule, valueIn(change.rule, change, own[change.rule])]));
  const swept =
    sweep === null
      ? null
      : amountsOf(sweep).map((amount) => valueIn(sweep.rule, { amount, isRelative: sweep.isRelative }, own[sweep.rule]));
  const values: TunedValue[] =
    sweep === null || swept === null
      ? [judge(level, base, null, changed, settings)]
      : swept.map((value) => judge(level, base, value, { ...changed, [sweep.rule]: value }, settings));
  const known = new Map(values.map(({ value, state }) => [value, state === 'kept']));
  const looked = sweep === null ? changes.map(({ rule }) => rule) : [sweep.rule];
  const intervals = looked.map((rule): RuleInterval => {
    const others = sweep === null ? {} : changed;
    const tried = swept ?? TRIED.map((share) => share * own[rule]).filter((v) => v >= RULES[rule].least && v <= RULES[rule].most);
    const rulesAt = (value: number) => ({ ...others, [rule]: value });
    const works = (value: number): boolean =>
      base !== null &&
      ((swept === null ? undefined : known.get(value)) ?? completes(sceneWith(level, rulesAt(value), settings), base.holds));
    const interval = intervalAround(own[rule], tried, works);
    const holds = (base ?? level.runs[0])?.holds ?? [];
    const hashes = new Set(
      [own[rule], tried[0], tried[tried.length - 1]].map((value) => hashOf(level, rulesAt(value), holds, settings)),
    );
    const nowhere = { low: null, high: null, isLowBound: false, isHighBound: false };
    return { rule, own: own[rule], ...(interval ?? nowhere), matters: hashes.size > 1 };
  });
  return { run: base?.name ?? null, values, intervals, room: roomOf(intervals) };
}

/** The smallest share of the level's own value by which a rule may change; 0 if the run fails without a change. */
function roomOf(intervals: readonly RuleInterval[]): number | null {
  let room: number | null = null;
  for (const { own, low, high, isLowBound, isHighBound } of intervals) {
    const scale = own === 0 ? 1 : own;
    const rooms =
      low === null || high === null ? [0] : [...(isLowBound ? [own - low] : []), ...(isHighBound ? [high - own] : [])];
    for (const r of rooms) room = room === null ? r / scale : Math.min(room, r / scale);
  }
  return room;
}

function valueIn(rule: RuleName, { amount, isRelative }: RuleValue, own: number): number {
  const value = isRelative ? amount * own : amount;
  const { least, most, unit } = RULES[rule];
  if (value >= least && value <= most) return value;
  throw new OutOfRange(`${rule}: ${amount}x of ${own} is ${value}; expected ${least} to ${most} ${unit}`);
}

const sceneWith = (level: Level, rules: OwnRules, { terms }: TuneSettings): Scene =>
  compile({ ...level, rules: { ...level.rules, ...rules } }, terms);

const completes = (scene: Scene, holds: readonly Hold[]): boolean =>
  simulate(scene, holds, { record: false, budget: new WorkBudget(scene.terms.maxWork) }).outcome === 'completed';

function firstThatCompletes(level: Level, rules: OwnRules, settings: TuneSettings): ScriptedRun | null {
  const scene = sceneWith(level, rules, settings);
  return level.runs.find(({ holds }) => completes(scene, holds)) ?? null;
}

/** A hash of every bit of a run; null if that takes more work than is allowed. */
function hashOf(level: Level, rules: OwnRules, holds: readonly Hold[], settings: TuneSettings): string | null {
  try {
    const budget = new WorkBudget(settings.terms.maxWork);
    return simulate(sceneWith(level, rules, settings), holds, { budget }).hash;
  } catch (error) {
    if (error instanceof WorkLimitReached) return null;
    throw error;
  }
}

function judge(
  level: Level,
  base: ScriptedRun | null,
  value: number | null,
  rules: OwnRules,
  settings: TuneSettings,
): TunedValue {
  const scene = sceneWith(level, rules, settings);
  if (base !== null && completes(scene, base.holds)) return { value, state: 'kept', holds: null };
  const other = level.runs.find((run) => run !== base && completes(scene, run.holds));
  if (other !== undefined) return { value, state: 'other', holds: other.holds };
  if (settings.search === null) return { value, state: 'unproven', holds: null };
  if (proveGoalImpossible(scene, { minerals: 'any' }) !== null) {
    return { value, state: 'impossible', holds: null };
  }
  const { best, impossible } = decideWithin(scene, settings.search.limits, settings.search.seed, 'first');
  if (best !== null) return { value, state: 'other', holds: best.holds };
  return { value, state: impossible === null ? 'unproven' : 'impossible', holds: null };
}

/** The precision of a threshold, as a share of the level's value. */
const PRECISION = 1e-3;

/** An interval of values that work, and whether each end is a real bound. */
interface Interval {
  readonly low: number;
  readonly high: number;
  readonly isLowBound: boolean;
  readonly isHighBound: boolean;
}

/** Goes from a value that works through the others to the first that fails, then narrows the threshold by bisection. */
function follow(own: number, others: readonly number[], works: (value: number) => boolean): { end: number; isBound: boolean } {
  let good = own;
  for (const value of others) {
    if (works(value)) {
      good = value;
      continue;
    }
    const precision = PRECISION * (own === 0 ? Math.abs(value) : Math.abs(own));
    for (let bad = value; Math.abs(bad - good) > precision; ) {
      const middle = (good + bad) / 2;
      if (works(middle)) good = middle;
      else bad = middle;
    }
    return { end: good, isBound: true };
  }
  return { end: good, isBound: false };
}

/**
 * The interval around a value in which something works. It tries the given values outwards, and narrows the threshold between
 * the last that works and the first that fails by bisection, to a thousandth of the value. A failure between two values that
 * work goes unnoticed.
 * @returns null if it doesn't work at the value itself
 */
export function intervalAround(own: number, values: readonly number[], works: (value: number) => boolean): Interval | null {
  if (!works(own)) return null;
  const sorted = [...values].sort((a, b) => a - b);
  const below = sorted.filter((value) => value < own).reverse();
  const low = follow(own, below, works);
  const above = sorted.filter((value) => value > own);
  const high = follow(own, above, works);
  return { low: low.end, high: high.end, isLowBound: low.isBound, isHighBound: high.isBound };
}
