import type { Goal } from '../../solver/index.ts';
import { type ConfiguredTerms, type TermsOptions, termsFrom } from '../terms.ts';
import type { MeasureSettings } from './measured-level.ts';

/** The options that say what to measure. */
interface MeasureOptions extends TermsOptions {
  readonly run?: string;
  readonly minerals: Goal['minerals'];
  readonly effort: number;
  readonly seed: number;
}

/** What the options and the configuration choose for a level of many. */
export function measureSettings(options: MeasureOptions, configuration: ConfiguredTerms): MeasureSettings {
  const { run = null, minerals, effort, seed } = options;
  const terms = termsFrom(options, configuration);
  return { terms, goal: { minerals }, run, effort, seed, inFull: false, withCurve: false };
}
