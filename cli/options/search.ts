import { type Command, InvalidArgumentError, Option } from 'commander';
import { plural } from '../../check/words/index.ts';
import type { Level } from '../../schema/index.ts';
import type { Goal, Objective } from '../../solver/index.ts';
import { Failure } from '../terminal/index.ts';
import { numberOption, seedOption, wholeNumberOption } from './common.ts';

/** s of wall time; applies if neither time nor effort is given */
export const DEFAULT_BUDGET = 10;

/** Ticks of a search that is to give the same on every machine, unless others are given. */
export const USUAL_EFFORT = 5_000_000;

/** s; the longest budget is one day */
const LONGEST_BUDGET = 86_400;

const MOST_MINERALS = 20_000;

/** The limits of a search. */
export interface Limits {
  /** s of wall time; null: no limit */
  readonly budget: number | null;
  /** simulated ticks in total; null: no limit */
  readonly effort: number | null;
}

/** The values of the options that `addSearchOptions` declares. */
export interface SearchOptions {
  readonly budget?: number;
  readonly effort?: number;
  readonly seed: number;
}

/** Declares the options for the limits and the seed of a search. */
export function addSearchOptions(command: Command, per = ''): Command {
  return command
    .option(
      '--budget <seconds>',
      `search at most this long${per} (default: ${DEFAULT_BUDGET}, or as long as --effort takes)`,
      numberOption('seconds', 0, LONGEST_BUDGET),
    )
    .option(
      '--effort <ticks>',
      `simulate at most this many ticks of 1/60 s${per}: gives the same answer on every machine`,
      wholeNumberOption('a number of ticks', 1, Number.MAX_SAFE_INTEGER),
    )
    .addOption(seedOption());
}

/** The limits that the options set. */
export const limitsOf = ({ budget, effort }: SearchOptions): Limits => ({
  budget: budget ?? (effort === undefined ? DEFAULT_BUDGET : null),
  effort: effort ?? null,
});

export const mineralsOption = (): Option =>
  new Option('--minerals <any|all|n>', 'how many minerals the run must collect').argParser(parseMinerals).default('any');

function parseMinerals(text: string): Goal['minerals'] {
  if (text === 'any' || text === 'all') return text;
  const count = Number(text);
  if (/^\d+$/.test(text) && count <= MOST_MINERALS) return count;
  throw new InvalidArgumentError('expected any, all or a whole number');
}

const OBJECTIVES: readonly Objective[] = ['robust', 'first', 'presses', 'time'];

export const objectiveOption = (): Option =>
  new Option(
    '--objective <what>',
    'which run is the best: the one that forgives most (robust), the first found, fewest presses, shortest time',
  )
    .choices(OBJECTIVES)
    .default('robust');

/** @throws Failure if a level has fewer minerals than are wanted */
export function expectMinerals(file: string, { minerals }: Level, wanted: Goal['minerals']): void {
  if (typeof wanted !== 'number' || wanted <= minerals.length) return;
  throw new Failure(`--minerals ${wanted}: ${file} has only ${plural(minerals.length, 'mineral')}`);
}
