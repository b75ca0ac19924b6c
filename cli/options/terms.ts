import { type Command, InvalidArgumentError, Option } from 'commander';
import {
  ACCURACIES,
  ACCURACY_LIMITS,
  type Accuracy,
  type AccuracyName,
  accuracyOf,
  DEFAULT_TERMS,
  maxTicksOf,
  type Terms,
  TICK_RATE,
} from '../../engine/basics/index.ts';
import { LONGEST_RUN, MOST_WORK } from '../../schema/basics/index.ts';
import type { ConfiguredTerms } from '../config/index.ts';
import { Failure } from '../terminal/index.ts';
import { numberOption, wholeNumberOption } from './common.ts';

/** The values of the options that `addTermsOptions` declares. An option that was not given is missing: it hides no configuration. */
export interface TermsOptions extends AccuracyOptions {
  /** s */
  readonly maxTime?: number;
  /** Pieces of motion. */
  readonly maxWork?: number;
}

interface AccuracyOptions {
  readonly accuracy?: AccuracyName;
  readonly integrator?: 'euler' | 'verlet' | 'rk4' | 'taylor';
  readonly rate?: number;
  readonly tolerance?: number;
  readonly contact?: 'frame' | 'swept';
}

const { rate: RATE, tolerance: TOLERANCE } = ACCURACY_LIMITS;

const EXAMPLES = 'for example --integrator rk4 --rate 120, or --integrator taylor --tolerance 1e-6';

/** What holds where an option is not given, for its help. */
const unlessGiven = (usual: string | number): string =>
  `(default: that of gq.config.json, else ${typeof usual === 'string' ? JSON.stringify(usual) : usual})`;

/** `--accuracy`, which names one. @param others what it takes beside names */
export const accuracyOption = (...others: readonly string[]): Option =>
  new Option('--accuracy <name>', `how exactly to simulate ${unlessGiven(DEFAULT_TERMS.accuracy.name)}`).choices([
    ...Object.keys(ACCURACIES),
    ...others,
  ]);

/** `--max-time`, the longest that a run may last. */
export const maxTimeOption = (): Option =>
  new Option(
    '--max-time <seconds>',
    `simulated time after which the outcome is a timeout ${unlessGiven(DEFAULT_TERMS.maxTime)}`,
  ).argParser((text: string) => {
    const seconds = numberOption('seconds', 0, LONGEST_RUN)(text);
    // a run has whole ticks
    if (maxTicksOf({ maxTime: seconds }) > 0) return seconds;
    throw new InvalidArgumentError(`expected seconds: at least one tick (1/${TICK_RATE} s), at most ${LONGEST_RUN}`);
  });

/** `--max-work`, the most work that a level may cost. */
export const maxWorkOption = (): Option =>
  new Option(
    '--max-work <pieces>',
    `most work that one level may cost, in pieces of motion ${unlessGiven(DEFAULT_TERMS.maxWork)}`,
  ).argParser(wholeNumberOption('pieces of motion', 1, MOST_WORK));

/**
 * Declares the options that say under which terms levels are judged.
 * @param accuracy the option that names the accuracy
 */
export const addTermsOptions = (command: Command, accuracy: Option = accuracyOption()): Command =>
  addCustomSetting(command.addOption(accuracy)).addOption(maxTimeOption()).addOption(maxWorkOption());

/** Declares the parts of a custom setting. */
const addCustomSetting = (command: Command): Command =>
  command
    .addOption(
      new Option('--integrator <name>', 'custom setting instead of --accuracy: the integrator').choices([
        'euler',
        'verlet',
        'rk4',
        'taylor',
      ]),
    )
    .option('--rate <hz>', 'custom setting: steps per second, for euler, verlet and rk4', parseRate)
    .option('--tolerance <px>', 'custom setting: error per second, for taylor', parseTolerance)
    .addOption(
      new Option(
        '--contact <test>',
        'custom setting: contact test, along the whole path or once a frame (default: "swept")',
      ).choices(['frame', 'swept']),
    );

const parseRate = (text: string): number => {
  const value = numberOption('steps a second', 0, RATE.most)(text);
  if (value >= RATE.least) return value;
  throw new InvalidArgumentError(`expected at least ${RATE.least} step a second`);
};

const parseTolerance = (text: string): number => {
  const value = numberOption('an error in px', 0, TOLERANCE.most)(text);
  if (value >= TOLERANCE.least) return value;
  throw new InvalidArgumentError(
    `expected an error of at least ${TOLERANCE.least} px: rounding of doubles exceeds anything smaller`,
  );
};

/**
 * The terms under which a command answers: of its options, then of the configuration, then the usual ones. The only place that
 * makes them.
 * @param options those of the command; {} for a command that has none of them
 * @throws Failure if the options contradict each other
 */
export function termsFrom(options: TermsOptions, configured: ConfiguredTerms): Terms {
  const name = options.accuracy ?? configured.accuracy;
  return {
    accuracy: customAccuracy(options) ?? (name === null ? DEFAULT_TERMS.accuracy : ACCURACIES[name]),
    maxTime: options.maxTime ?? configured.maxTime ?? DEFAULT_TERMS.maxTime,
    maxWork: options.maxWork ?? configured.maxWork ?? DEFAULT_TERMS.maxWork,
    rules: configured.rules,
  };
}

/**
 * The custom setting that the options describe; null if there is none.
 * @throws Failure if they contradict each other
 */
export function customAccuracy({ accuracy, integrator, rate, tolerance, contact }: AccuracyOptions): Accuracy | null {
  if (integrator === undefined) {
    const part =
      rate !== undefined ? '--rate' : tolerance !== undefined ? '--tolerance' : contact !== undefined ? '--contact' : '';
    if (part === '') return null;
    throw new Failure(`${part} is part of a custom setting: expected --integrator with it, ${EXAMPLES}`);
  }
  if (accuracy !== undefined) {
    throw new Failure(
      `--accuracy ${accuracy} and --integrator ${integrator} cannot be combined: give a name or the parts of a custom setting`,
    );
  }
  if (integrator === 'taylor') {
    if (rate !== undefined) {
      throw new Failure(
        `--rate ${rate}: taylor chooses its own steps: expected --tolerance instead, for example --tolerance 1e-6`,
      );
    }
    if (tolerance === undefined) {
      throw new Failure('--integrator taylor: expected --tolerance with it (an error in px), for example --tolerance 1e-6');
    }
  } else {
    if (tolerance !== undefined) {
      throw new Failure(
        `--tolerance ${tolerance}: ${integrator} has fixed steps: expected --rate instead, for example --rate 120`,
      );
    }
    if (rate === undefined) {
      throw new Failure(`--integrator ${integrator}: expected --rate with it (steps per second), for example --rate 120`);
    }
  }
  return accuracyOf({ integrator, rate: rate ?? null, tolerance: tolerance ?? null, contact: contact ?? 'swept' });
}
