import { parseArgs } from 'node:util';
import { ACCURACIES, type AccuracyName } from '../../engine/index.ts';

/** What a benchmark can be told on the command line: how the text is read, and what holds without it. */
export interface Option<T> {
  /** What it is for, in words. */
  readonly what: string;
  readonly otherwise: T;
  /** Whether it stands alone, without a value. */
  readonly isFlag?: boolean;
  /** @throws {Error} that says what is expected */
  read(text: string): T;
}

/** Options by their names: `mineralSeeds` is `--mineral-seeds`. */
export type Options = Readonly<Record<string, Option<unknown>>>;

/** The values of options. */
export type Asked<O extends Options> = { readonly [K in keyof O]: O[K] extends Option<infer T> ? T : never };

/** A limit for a figure. */
export interface Limit {
  readonly what: string;
  readonly bound: 'at most' | 'at least';
  readonly limit: number;
}

/** What a benchmark found out. */
export interface Report<C extends string = string> {
  readonly title: string;
  readonly columns: readonly string[];
  readonly rows: readonly (readonly (string | number | null)[])[];
  /** The figure of each claim, or several by what they are figures of; null where it was not measured this time. */
  readonly measured: Readonly<Record<C, number | Readonly<Record<string, number>> | null>>;
  readonly notes: readonly string[];
}

/** A benchmark; its name stands in the list of all. */
export interface Bench<O extends Options = Options, C extends string = string> {
  /** What it measures, in a line. */
  readonly what: string;
  readonly options: O;
  /** What has to hold. */
  readonly claims: Readonly<Record<C, Limit>>;
  /** Flags of the process that it needs. */
  readonly flags?: readonly string[];
  run(asked: Asked<O>): Report<C> | Promise<Report<C>>;
}

/** Keeps the types of options and claims together. */
export const define = <O extends Options, C extends string>(bench: Bench<O, C>): Bench<O, C> => bench;

export const atMost = (limit: number, what: string): Limit => ({ what, bound: 'at most', limit });
export const atLeast = (limit: number, what: string): Limit => ({ what, bound: 'at least', limit });

/** A number; null where there may be none. */
export function number<T extends number | null>(otherwise: T, what: string): Option<T | number> {
  return {
    what,
    otherwise,
    read(text) {
      const value = Number(text);
      if (text.trim() === '' || !Number.isFinite(value) || value < 0) throw new Error('expected a number, 0 or more');
      return value;
    },
  };
}

/** Numbers between commas. */
export const numbers = <T extends readonly number[] | null>(otherwise: T, what: string): Option<T | readonly number[]> => ({
  what,
  otherwise,
  read: (text) => text.split(',').map((one) => number(0, what).read(one)),
});

/** Any text; null where there may be none. */
export const text = (what: string): Option<string | null> => ({ what, otherwise: null, read: (given) => given });

/** Texts between commas. */
export const words = (what: string): Option<readonly string[] | null> => ({
  what,
  otherwise: null,
  read: (given) => given.split(','),
});

/** One of some names. */
export const oneOf = <N extends string, T extends N | null>(names: readonly N[], otherwise: T, what: string): Option<T | N> => ({
  what: `${what}: ${names.join(', ')}`,
  otherwise,
  read(given) {
    const found = names.find((name) => name === given);
    if (found === undefined) throw new Error(`expected one of ${names.join(', ')}`);
    return found;
  },
});

/** An option without a value. */
export const flag = (what: string): Option<boolean> => ({ what, otherwise: false, isFlag: true, read: () => true });

/** Every accuracy with a name, from the cheapest on. */
export const ACCURACY_NAMES = Object.keys(ACCURACIES) as readonly AccuracyName[];

export const accuracy = <T extends AccuracyName | null>(otherwise: T): Option<T | AccuracyName> =>
  oneOf(ACCURACY_NAMES, otherwise, 'the accuracy');

/** As it is written on a command line. */
export const optionName = (key: string): string => key.replace(/[A-Z]/g, (letter) => `-${letter.toLowerCase()}`);

/**
 * Reads the options of a benchmark.
 * @throws {Error} for an unknown option, and for a value that cannot be read
 */
export function readOptions<O extends Options>(options: O, args: readonly string[]): Asked<O> {
  const { values } = parseArgs({
    args: [...args],
    options: Object.fromEntries(
      Object.entries(options).map(([key, { isFlag }]) => [
        optionName(key),
        { type: isFlag ? 'boolean' : 'string', multiple: true } as const,
      ]),
    ),
  });
  const read = Object.entries(options).map(([key, option]) => {
    const given = values[optionName(key)];
    if (given === undefined) return [key, option.otherwise];
    try {
      // given several times, it has several values
      return [key, option.read(given.join())];
    } catch (error) {
      throw new Error(`--${optionName(key)}: ${(error as Error).message}, found ${given}`);
    }
  });
  return Object.fromEntries(read);
}
