import { accuracyInWords, plural } from '../../../check/words/index.ts';
import { STATE_WORDS } from '../../../picture/tune/index.ts';
import { RULE_NAMES, RULES, type RuleName, type TuneReport } from '../../../schema/index.ts';
import { type Colors, visibleLine } from '../../terminal/index.ts';
import {
  amountsOf,
  type Change,
  type RuleInterval,
  type Sweep,
  type TunedLevel,
  type TunedState,
  type TuneSettings,
} from '../../tune/index.ts';

/** The largest number of columns of the matrix: a line with name and interval has 80 characters. */
const MOST_COLUMNS = 41;
const NAME = 20;
/** The same on a terminal with less than 80 characters. */
const NARROW_NAME = 12;

const SIGNS: Readonly<Record<TunedState, string>> = { kept: '#', other: 'o', unproven: '.', impossible: 'x' };
const WORST: readonly TunedState[] = ['impossible', 'unproven', 'other', 'kept'];

const brief = (value: number): string => String(Number(value.toPrecision(4)));
const amount = (value: number, isRelative: boolean): string => `${brief(value)}${isRelative ? 'x' : ''}`;

/** An interval such as `37.1..>46.8`; nothing was tried beyond a number with > or <. */
function intervalText({ run }: TunedLevel, { low, high, isLowBound, isHighBound }: RuleInterval): string {
  if (run === null) return 'no run';
  if (low === null || high === null) return 'its run fails';
  return `${isLowBound ? '' : '<'}${brief(low)}..${isHighBound ? '' : '>'}${brief(high)}`;
}

function nameText({ name }: TunedLevel, size = NAME): string {
  const letters = [...visibleLine(name)];
  return (letters.length > size ? `${letters.slice(0, size - 1).join('')}…` : letters.join('')).padEnd(size);
}

const changeText = ({ rule, amount: value, isRelative }: Change): string => `${rule}=${amount(value, isRelative)}`;

/** One sign for each value; if there are too many, neighbours share the sign of the worst. */
function matrixRow(states: readonly TunedState[], most: number): string {
  const columns = Math.min(most, states.length);
  return Array.from({ length: columns }, (_, c) => {
    const from = Math.floor((c * states.length) / columns);
    const to = Math.max(from + 1, Math.floor(((c + 1) * states.length) / columns));
    const part = states.slice(from, to);
    return SIGNS[WORST.find((state) => part.includes(state)) ?? 'kept'];
  }).join('');
}

/** Marks the levels' own values, if there is room for them on a scale of shares. */
function withOwn(scale: string, from: number, to: number, columns: number, isRelative: boolean): string {
  const at = Math.round(((1 - from) / (to - from)) * (columns - 1));
  const isFree = scale.slice(Math.max(0, at - 1), at + 3) === '    ';
  return isRelative && at > 0 && isFree ? `${scale.slice(0, at)}1x${scale.slice(at + 2)}` : scale;
}

function matrix(
  levels: readonly TunedLevel[],
  { rule, from, to, count, isRelative }: Sweep,
  colors: Colors,
  narrow: number | null,
): string[] {
  const size = narrow === null ? NAME : NARROW_NAME;
  const most = narrow === null ? MOST_COLUMNS : Math.max(1, Math.min(MOST_COLUMNS, narrow - size - 1));
  // on a narrow terminal, what stands beside the signs stands below them
  const gap = narrow === null ? ' ' : '\n  ';
  const columns = Math.min(most, count);
  const [left, right] = [amount(from, isRelative), amount(to, isRelative)];
  const scale = withOwn(left + right.padStart(Math.max(right.length + 1, columns - left.length)), from, to, columns, isRelative);
  return [
    colors.dim(`${'level'.padEnd(size)} ${scale}${gap}${rule}, ${RULES[rule].unit}`),
    ...levels.map((level) => {
      const row = matrixRow(
        level.values.map(({ state }) => state),
        most,
      ).padEnd(narrow === null ? scale.length : 0);
      return `${nameText(level, size)} ${row}${gap}${level.intervals.map((interval) => intervalText(level, interval)).join(' ')}`;
    }),
  ];
}

/** One line for each level, and one more for each further rule. */
function list(levels: readonly TunedLevel[], narrow: number | null): string[] {
  return levels.flatMap((level) => {
    const state = (level.values[0] === undefined ? '' : STATE_WORDS[level.values[0].state]).padEnd(20);
    if (narrow !== null) {
      const below = level.intervals.map((interval) => `  ${interval.rule} ${intervalText(level, interval)}`);
      return [nameText(level).trimEnd(), `  ${state}`.trimEnd(), ...below].filter((line) => line !== '');
    }
    return level.intervals.map((interval, i) => {
      const before = i === 0 ? `${nameText(level)} ${state}` : ' '.repeat(NAME + 21);
      return `${before} ${interval.rule} ${intervalText(level, interval)}`.trimEnd();
    });
  });
}

/** The results of `tune` for people: at most 80 characters in a line, or as many as a narrower terminal has. */
export function tuneText(
  levels: readonly TunedLevel[],
  { terms, changes, sweep }: TuneSettings,
  colors: Colors,
  width: number | null = null,
): string {
  const narrow = width !== null && width < 80 ? width : null;
  const looked = levels.filter(({ code }) => code === 0);
  const set = changes.map(changeText).join(' ');
  const title = sweep === null ? `with ${set}` : `${sweep.rule} at ${sweep.count} values${set === '' ? '' : `, with ${set}`}`;
  const kept = looked.filter(({ values }) => values.every(({ state }) => state === 'kept')).length;
  const signs = (Object.keys(SIGNS) as TunedState[])
    .map((state) => `${SIGNS[state]} ${STATE_WORDS[state]}`)
    .join(narrow === null ? '  ' : '\n');
  const lines = [
    colors.bold(`${title}, accuracy ${accuracyInWords(terms)}`),
    ...(sweep === null ? list(looked, narrow) : [...matrix(looked, sweep, colors, narrow), colors.dim(signs)]),
    `${kept} of ${plural(looked.length, 'level')} ${kept === 1 ? 'keeps its' : 'keep their'} run${sweep === null ? '' : ' at every value'}`,
  ];
  const independent = independentRules(looked);
  if (independent.length > 0) lines.push(`no level depends on ${independent.join(', ')}`);
  return `${lines.join('\n')}\n`;
}

/** The results of `tune` as JSON. */
export function tuneJson(levels: readonly TunedLevel[], { terms, changes, sweep }: TuneSettings): string {
  const report: TuneReport = {
    version: 1,
    accuracy: terms.accuracy.name,
    changes: changes.map((change) => ({ ...change })),
    sweep: sweep === null ? null : { rule: sweep.rule, isRelative: sweep.isRelative, amounts: amountsOf(sweep) },
    levels: levels.map(({ file, name, terms: own, run, room, values, intervals, why }) => ({
      file,
      name,
      terms: own,
      run,
      room,
      values: values.map(({ value, state, holds }) => ({
        value,
        state,
        holds: holds?.map(([press, release]) => [press, release] as [number, number]) ?? null,
      })),
      intervals: intervals.map((interval) => ({ ...interval })),
      why: why === '' ? null : why,
    })),
    independent: independentRules(levels),
  };
  return `${JSON.stringify(report)}\n`;
}

/** The rules that were tried and that no level depends on. */
function independentRules(levels: readonly TunedLevel[]): RuleName[] {
  const intervals = levels.flatMap((level) => level.intervals);
  return RULE_NAMES.filter((name) => {
    const tried = intervals.filter(({ rule }) => rule === name);
    return tried.length > 0 && tried.every(({ matters }) => !matters);
  });
}
