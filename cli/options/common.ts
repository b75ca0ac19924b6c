import { type Command, InvalidArgumentError, Option } from 'commander';
import { Failure, namedPath } from '../terminal/index.ts';

/** Parses a number within bounds. */
export function numberOption(what: string, above: number, max: number): (text: string) => number {
  return (text) => {
    const value = /^\s*$/.test(text) ? Number.NaN : Number(text);
    if (value > above && value <= max) return value;
    throw new InvalidArgumentError(`expected ${what}: more than ${above}, at most ${max}`);
  };
}

/** Parses a whole number within bounds. */
export function wholeNumberOption(what: string, min: number, max: number): (text: string) => number {
  return (text) => {
    const value = Number(text);
    if (/^\d+$/.test(text) && value >= min && value <= max) return value;
    throw new InvalidArgumentError(`expected ${what}: a whole number from ${min} to ${max}`);
  };
}

/** For an option that can be given several times. */
export const collect = (path: string, before: readonly string[] = []): readonly string[] => [...before, path];

export const formatOption = (...formats: string[]): Option =>
  new Option('--format <format>', 'format of the report').choices(formats).default(formats[0]);

export const LARGEST_SEED = 2 ** 32 - 1;

export const seedOption = (): Option =>
  new Option('--seed <n>', 'seed of the random numbers: the same seed gives the same result')
    .argParser(wholeNumberOption('a seed', 0, LARGEST_SEED))
    .default(0);

export const jobsOption = (most: number): Option =>
  new Option('-j, --jobs <n>', 'most worker threads to use')
    .argParser(wholeNumberOption('a number of threads', 1, 256))
    .default(most);

/** An option that has an effect only together with another. */
export interface Dependence {
  /** Its long name: `--seed`. */
  readonly option: string;
  /** Whether it has an effect. */
  readonly isUsed: boolean;
  /** The options of which one is needed: `--solve`. */
  readonly needs: string;
}

/** @throws Failure if an option was given that has no effect: the user expects one */
export function refuseUnused(command: Command, dependences: readonly Dependence[]): void {
  for (const { option, isUsed, needs } of dependences) {
    if (isUsed || !isGiven(command, option)) continue;
    throw new Failure(`${option} has no effect without ${needs}: give ${needs} as well, or leave ${option} out`);
  }
}

function isGiven(command: Command, name: string): boolean {
  const option = command.options.find(({ long }) => long === name);
  if (option === undefined) throw new Error(`${command.name()} has no option ${name}`);
  return command.getOptionValueSource(option.attributeName()) === 'cli';
}

/** The values of the options that `addShardOptions` declares. */
export interface ShardOptions {
  readonly plan?: string;
  readonly shard?: string;
  readonly out?: string;
}

/** Declares the options for a shard of a plan. */
export const addShardOptions = (command: Command): Command =>
  command
    .option('--plan <file>', 'do one shard of a plan of gq plan, which has the paths and all other options')
    .option('--shard <i>', 'with --plan: which one: 3 from 0, 4/8 from 1, or auto: from the system that runs it')
    .option('--out <dir>', 'with --plan: the directory for its result');

/** Options that a shard takes besides those of the plan. */
const OWN = new Set(['plan', 'shard', 'out', 'jobs']);

/** @throws Failure if an option is given that only a plan can have, or one of a shard without a plan */
export function refuseBesidesPlan(command: Command, paths: readonly string[], { plan, shard, out }: ShardOptions): void {
  if (plan === undefined) {
    const given = shard !== undefined ? '--shard' : out !== undefined ? '--out' : null;
    if (given !== null) throw new Failure(`${given} is for a shard of a plan: expected --plan FILE with it; gq plan makes one`);
    return;
  }
  if (shard === undefined) throw new Failure('--plan: expected --shard with it: 3 (from 0), 4/8 (from 1) or auto');
  if (out === undefined) throw new Failure('--plan: expected --out DIR with it, the directory for the result');
  if (paths.length > 0) throw new Failure(`the plan has the paths: expected none with --plan, found ${namedPath(paths[0])}`);
  for (const option of command.options) {
    const name = option.attributeName();
    if (OWN.has(name) || command.getOptionValueSource(name) !== 'cli') continue;
    throw new Failure(`${option.long} comes from the plan: give it to gq plan, not with --plan`);
  }
}
