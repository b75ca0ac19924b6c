import { InvalidArgumentError, Option } from 'commander';
import { DEFAULT_MAX_TIME, DEFAULT_MAX_WORK, TICK_RATE } from '../engine/basics/index.ts';

/** s; the longest run that is ever simulated: one hour, the limit of holds in a level file */
const LONGEST_RUN = 3600;

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

export const maxTimeOption = (): Option =>
  new Option('--max-time <seconds>', 'simulated time after which the outcome is a timeout')
    .argParser((text: string) => {
      const seconds = numberOption('seconds', 0, LONGEST_RUN)(text);
      // a run has whole ticks
      if (Math.round(seconds * TICK_RATE) > 0) return seconds;
      throw new InvalidArgumentError(`expected seconds: at least one tick (1/${TICK_RATE} s), at most ${LONGEST_RUN}`);
    })
    .default(DEFAULT_MAX_TIME);

/** The largest work that an option may allow: counts must stay exact whole numbers. */
const MOST_WORK = 1e12;

export const maxWorkOption = (): Option =>
  new Option('--max-work <pieces>', 'most work that one level may cost, in pieces of motion')
    .argParser(wholeNumberOption('pieces of motion', 1, MOST_WORK))
    .default(DEFAULT_MAX_WORK);

export const LARGEST_SEED = 2 ** 32 - 1;

export const seedOption = (): Option =>
  new Option('--seed <n>', 'seed of the random numbers: the same seed gives the same result')
    .argParser(wholeNumberOption('a seed', 0, LARGEST_SEED))
    .default(0);

export const jobsOption = (most: number): Option =>
  new Option('-j, --jobs <n>', 'most worker threads to use')
    .argParser(wholeNumberOption('a number of threads', 1, 256))
    .default(most);
