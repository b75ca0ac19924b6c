import type { Goal } from '../../solver/index.ts';
import { type AccuracyOptions, chooseAccuracy } from '../accuracy-options.ts';
import type { Configuration } from '../configuration.ts';
import type { MeasureSettings } from './measured-level.ts';

/** The options that say what to measure. */
interface MeasureOptions extends AccuracyOptions {
  readonly run?: string;
  readonly minerals: Goal['minerals'];
  readonly effort: number;
  readonly seed: number;
  readonly maxTime: number;
}

/** What the options and the configuration choose for a level of many. */
export function measureSettings(options: MeasureOptions, configuration: Configuration): MeasureSettings {
  const { run = null, minerals, effort, seed, maxTime } = options;
  const accuracy = chooseAccuracy(options, configuration);
  const { rules } = configuration;
  return { rules, accuracy, goal: { minerals }, run, effort, seed, maxTime, inFull: false, withCurve: false };
}
