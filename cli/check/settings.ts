import type { Configuration, ConfiguredTerms } from '../config/index.ts';
import { limitsOf, type SearchOptions, type TermsOptions, termsFrom } from '../options/index.ts';
import { Failure } from '../terminal/index.ts';
import type { CheckedLevel, CheckSettings } from './checked-level.ts';

/**
 * With more files than this, proofs about minerals are not tried, unless --solve takes its time anyway: a check of a thousand
 * levels must not keep the user waiting.
 */
export const FEW_FILES = 64;

/** Ticks that the search for places where a level is already lost takes by default. */
export const SOFTLOCK_EFFORT = 10_000_000;

/** The options that say what a check asks of each level. */
export interface AskedOptions extends SearchOptions, TermsOptions {
  readonly solve?: true;
  /** false with --no-require-slack */
  readonly requireSlack?: number | false;
  readonly softlocks?: number | true;
}

/** @throws Failure if a limit is given for a search that is not asked for */
export function refuseLimitsWithoutSearch({ solve, budget, effort }: AskedOptions): void {
  const part = budget !== undefined ? '--budget' : effort !== undefined ? '--effort' : null;
  if (!solve && part !== null) throw new Failure(`${part} limits the search of --solve: give --solve as well`);
}

/** What a check of so many files asks of each level, except for the extent of the report. */
export function settingsFor(
  options: AskedOptions,
  configuration: ConfiguredTerms & Pick<Configuration, 'requireSlack'>,
  count: number,
): Omit<CheckSettings, 'inFull'> {
  const { solve = false, seed, softlocks } = options;
  return {
    terms: termsFrom(options, configuration),
    search: solve ? { limits: limitsOf(options), seed } : null,
    proveMinerals: solve || count <= FEW_FILES,
    requireSlack: slackOf(options.requireSlack, configuration.requireSlack),
    ...(softlocks !== undefined && { softlocks: softlocks === true ? SOFTLOCK_EFFORT : softlocks }),
  };
}

/** The ticks that are required; null: none. The command line wins over the configuration, where 0 requires nothing. */
function slackOf(asked: number | false | undefined, configured: number | null): number | null {
  if (asked === false) return null;
  return asked ?? (configured || null);
}

type Configured = Pick<Configuration, 'severity'>;

/** Applies what a configuration and a level say about its problems. The verdict stays. */
export async function judgeOf({ severity }: Configured): Promise<(level: CheckedLevel) => CheckedLevel> {
  // imported only if needed: it loads the schema, which usually only the workers load
  const { applyPolicy } = await import('../../check/policy/index.ts');
  return (level) => ({ ...level, ...applyPolicy(level.problems, { severity, allow: level.allow ?? {} }) });
}

/** Applies what a configuration and each level say about problems. Verdicts stay. */
export async function judgeLevels(levels: readonly CheckedLevel[], configuration: Configured): Promise<readonly CheckedLevel[]> {
  const isPlain = Object.keys(configuration.severity).length === 0 && levels.every(({ allow }) => allow === undefined);
  return isPlain ? levels : levels.map(await judgeOf(configuration));
}
