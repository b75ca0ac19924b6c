import { InvalidArgumentError, Option } from 'commander';

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
