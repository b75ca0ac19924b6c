import { InvalidArgumentError } from 'commander';
import { closestName, RULE_NAMES, RULES, type RuleName } from '../../schema/index.ts';

/** A value for a rule: absolute, or a share of the level's value. */
export interface RuleValue {
  readonly amount: number;
  readonly isRelative: boolean;
}

/** A rule and its new value. */
export interface Change extends RuleValue {
  readonly rule: RuleName;
}

/** Evenly spaced values of a rule. */
export interface Sweep {
  readonly rule: RuleName;
  readonly from: number;
  readonly to: number;
  /** at least 2 */
  readonly count: number;
  readonly isRelative: boolean;
}

const MOST_VALUES = 1001;

/** The allowed shares of a level's value. */
const MOST_RELATIVE = 1000;

const NUMBER = /^(\d+(?:\.\d+)?|\.\d+)(x?)$/;

function parseName(text: string): RuleName {
  const known = RULE_NAMES.find((name) => name === text);
  if (known !== undefined) return known;
  const close = closestName(text, RULE_NAMES);
  const guess = close === null ? '' : ` (did you mean ${close}?)`;
  throw new InvalidArgumentError(`unknown rule ${JSON.stringify(text)}${guess}; the rules are ${RULE_NAMES.join(', ')}`);
}

function parseValue(rule: RuleName, text: string): RuleValue {
  const match = NUMBER.exec(text);
  if (match === null) {
    throw new InvalidArgumentError(
      `expected a number, or a multiple of the level's value like 1.1x, found ${JSON.stringify(text)}`,
    );
  }
  const amount = Number(match[1]);
  const isRelative = match[2] === 'x';
  const { least, most, unit } = RULES[rule];
  if (isRelative && amount > MOST_RELATIVE) throw new InvalidArgumentError(`expected at most ${MOST_RELATIVE}x, found ${text}`);
  if (!isRelative && (amount < least || amount > most)) {
    throw new InvalidArgumentError(`${rule}: expected ${least} to ${most} ${unit}, found ${text}`);
  }
  return { amount, isRelative };
}

/** Parses `pull=1.1x` or `pull=45` and appends it to the previous changes. */
export function parseChange(text: string, before: readonly Change[] = []): readonly Change[] {
  const at = text.indexOf('=');
  if (at < 0) throw new InvalidArgumentError('expected RULE=VALUE, for example pull=1.1x or pull=45');
  const rule = parseName(text.slice(0, at));
  if (before.some((change) => change.rule === rule)) throw new InvalidArgumentError(`${rule} is set twice`);
  return [...before, { rule, ...parseValue(rule, text.slice(at + 1)) }];
}

/** Parses `pull=0.8x..1.2x:41`. */
export function parseSweep(text: string): Sweep {
  const match = /^([^=]*)=(.+?)\.\.(.+):(\d+)$/.exec(text);
  if (match === null) {
    throw new InvalidArgumentError('expected RULE=FROM..TO:COUNT, for example pull=0.8x..1.2x:41');
  }
  const rule = parseName(match[1]);
  const [from, to] = [parseValue(rule, match[2]), parseValue(rule, match[3])];
  if (from.isRelative !== to.isRelative) {
    throw new InvalidArgumentError('expected both ends as numbers, or both as multiples like 0.8x..1.2x');
  }
  if (from.amount >= to.amount) throw new InvalidArgumentError(`expected FROM below TO, found ${match[2]}..${match[3]}`);
  const count = Number(match[4]);
  if (count < 2 || count > MOST_VALUES) throw new InvalidArgumentError(`expected 2 to ${MOST_VALUES} values, found ${count}`);
  return { rule, from: from.amount, to: to.amount, count, isRelative: from.isRelative };
}

/** The values of a sweep, as given: absolute, or shares of a level's value. */
export const amountsOf = ({ from, to, count }: Sweep): number[] =>
  Array.from({ length: count }, (_, i) => from + ((to - from) * i) / (count - 1));
