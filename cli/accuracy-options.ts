import { type Command, InvalidArgumentError, Option } from 'commander';
import {
  ACCURACIES,
  ACCURACY_LIMITS,
  type Accuracy,
  type AccuracyName,
  accuracyOf,
  DEFAULT_ACCURACY,
} from '../engine/basics/index.ts';
import type { Configuration } from './configuration.ts';
import { Failure } from './failure.ts';
import { numberOption } from './options.ts';

/** The values of the options that `addAccuracyOptions` declares. */
export interface AccuracyOptions {
  readonly accuracy?: AccuracyName;
  readonly integrator?: 'euler' | 'verlet' | 'rk4' | 'taylor';
  readonly rate?: number;
  readonly tolerance?: number;
  readonly contact?: 'frame' | 'swept';
}

const { rate: RATE, tolerance: TOLERANCE } = ACCURACY_LIMITS;

const EXAMPLES = 'for example --integrator rk4 --rate 120, or --integrator taylor --tolerance 1e-6';

/** Declares `--accuracy` and the options of a custom setting. */
export function addAccuracyOptions(command: Command): Command {
  return command
    .addOption(
      new Option('--accuracy <name>', `how exactly to simulate (default: "${DEFAULT_ACCURACY}")`).choices(
        Object.keys(ACCURACIES),
      ),
    )
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
}

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
 * The accuracy that the options select, else that of the configuration, else the default.
 * @throws Failure if they contradict each other
 */
export function chooseAccuracy(options: AccuracyOptions, configured: Pick<Configuration, 'accuracy'>): Accuracy {
  return customAccuracy(options) ?? ACCURACIES[options.accuracy ?? configured.accuracy ?? DEFAULT_ACCURACY];
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
