import type { Command } from 'commander';
import type { Goal, Objective } from '../../../solver/index.ts';
import { type AskedOptions, refuseLimitsWithoutSearch, settingsFor } from '../../check/index.ts';
import type { ConfigOptions, Configuration } from '../../config/index.ts';
import { measureSettings } from '../../difficulty/index.ts';
import { unreadableFolders } from '../../find/index.ts';
import type { JobName } from '../../fleet/index.ts';
import { limitsOf, refuseUnused, USUAL_EFFORT } from '../../options/index.ts';
import { askedRuns } from '../../solve/index.ts';
import { Failure } from '../../terminal/index.ts';
import { type PlayOptions, planned, playSettings, unusableLevels } from '../../verify/index.ts';

/** Options of the commands that shards run. */
export interface PlanOptions extends ConfigOptions, AskedOptions, Omit<PlayOptions, 'accuracy'> {
  readonly maxWarnings?: number;
  readonly brief?: true;
  readonly minerals: Goal['minerals'];
  readonly objective: Objective;
  readonly count: number;
  readonly run?: string;
}

/** What a plan says about its job. */
export interface JobOrder {
  readonly settings: object;
  readonly report: Record<string, unknown>;
  /** What the user should know, for stderr. */
  readonly messages?: string;
}

type MakeOrder = (options: PlanOptions, configuration: Configuration, command: Command) => JobOrder | Promise<JobOrder>;

/** What each command makes of the options. */
export const ORDERS: Readonly<Record<JobName, MakeOrder>> = {
  check: checkOrder,
  solve: solveOrder,
  difficulty: difficultyOrder,
  verify: verifyOrder,
};

const TERMS = ['--accuracy', '--integrator', '--rate', '--tolerance', '--contact', '--max-time', '--max-work'];
const SEARCH = ['--budget', '--effort', '--seed'];

/** The options that are for some of the commands only. */
const OPTIONS_OF: Readonly<Record<JobName, readonly string[]>> = {
  check: [...TERMS, ...SEARCH, '--solve', '--require-slack', '--no-require-slack', '--max-warnings', '--brief'],
  solve: [...TERMS, ...SEARCH, '--minerals', '--objective', '--count'],
  difficulty: [...TERMS, ...SEARCH, '--run', '--minerals'],
  verify: ['--accuracy', '--levels', '--engines', '--challenge-key', '--now', '--max-ticks', '--max-work'],
};

/** @throws Failure if an option is given that the command of the shards does not have */
export function refuseOfOthers(job: JobName, command: Command): void {
  if (job !== 'verify' && command.getOptionValue('accuracy') === 'any')
    throw new Failure('--accuracy any is for plays: expected the name of an accuracy, or --for verify');
  const own = OPTIONS_OF[job];
  const others = new Set(Object.values(OPTIONS_OF).flat());
  for (const option of command.options) {
    const { long } = option;
    if (long == null || !others.has(long) || own.includes(long)) continue;
    if (command.getOptionValueSource(option.attributeName()) !== 'cli') continue;
    const users = (Object.keys(OPTIONS_OF) as JobName[]).filter((name) => OPTIONS_OF[name].includes(long));
    throw new Failure(
      `${long} has no effect on gq ${job}: leave it out, or plan another command: --for ${users.join(' or --for ')}`,
    );
  }
}

function checkOrder(options: PlanOptions, configuration: Configuration, command: Command): JobOrder {
  refuseLimitsWithoutSearch(options);
  refuseTime(options);
  refuseUnused(command, [{ option: '--seed', isUsed: options.solve === true, needs: '--solve' }]);
  const effort = options.solve ? (options.effort ?? USUAL_EFFORT) : undefined;
  const { severity } = configuration;
  // what is tried must not depend on how many levels there are
  const settings = settingsFor({ ...options, effort }, configuration, Number.POSITIVE_INFINITY);
  return {
    settings: { ...settings, inFull: !options.brief },
    report: { terms: settings.terms, severity, maxWarnings: options.maxWarnings ?? configuration.maxWarnings },
  };
}

function solveOrder(options: PlanOptions, configuration: Configuration): JobOrder {
  refuseTime(options);
  const { seed, effort = USUAL_EFFORT } = options;
  return { settings: { ...askedRuns(options, configuration), limits: limitsOf({ effort, seed }) }, report: {} };
}

function difficultyOrder(options: PlanOptions, configuration: Configuration): JobOrder {
  refuseTime(options);
  const { effort = USUAL_EFFORT } = options;
  return { settings: measureSettings({ ...options, effort }, configuration), report: {} };
}

async function verifyOrder(options: PlanOptions, configuration: Configuration, command: Command): Promise<JobOrder> {
  refuseUnused(command, [{ option: '--now', isUsed: options.challengeKey !== undefined, needs: '--challenge-key' }]);
  const { settings, unreadable } = await playSettings(options, configuration);
  if (unreadable.length > 0) throw unreadableFolders(unreadable);
  return { settings: planned(settings), report: {}, messages: unusableLevels(settings) };
}

/** @throws Failure if a search is to end by the clock */
function refuseTime({ budget }: Pick<PlanOptions, 'budget'>): void {
  if (budget === undefined) return;
  throw new Failure(
    `--budget ${budget}: by the clock, each machine would get other results: expected --effort TICKS, which is the same on all (default: ${USUAL_EFFORT})`,
  );
}
