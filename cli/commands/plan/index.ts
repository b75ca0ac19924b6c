import { type Command, Option } from 'commander';
import { plural } from '../../../check/words/index.ts';
import type { CommandHelp, CommandResult } from '../../command.ts';
import { addConfigOptions, readConfiguration } from '../../config/index.ts';
import { PATHS, pathsOr } from '../../find/index.ts';
import { contentsOf, ignoreFor, JOBS, type JobName, MOST_SHARDS, makePlan, planText, readCosts } from '../../fleet/index.ts';
import { readRegularFile, statOrError, writeWhole } from '../../io/index.ts';
import {
  accuracyOption,
  addSearchOptions,
  addTermsOptions,
  mineralsOption,
  objectiveOption,
  wholeNumberOption,
} from '../../options/index.ts';
import { createStatusLine, Failure, namedPath, shellPath } from '../../terminal/index.ts';
import { addPlayOptions } from '../../verify/index.ts';
import { ORDERS, type PlanOptions, refuseOfOthers } from './orders.ts';

interface Options extends PlanOptions {
  readonly shards: number;
  readonly output: string;
  readonly for: JobName;
  readonly costs?: string;
  readonly force?: true;
}

export const help: CommandHelp = {
  description: 'Split a large set of levels or plays into shards that any number of machines can do.',
  more: `
The plan holds what must be equal everywhere: the version of gq, the options, and a hash over the set. It is a rule and not a list:
the shard of a level is the first 32 bits of the SHA-256 of its bytes, modulo the number of shards. With --costs, levels are
spread by what they have cost, the longest first. Limits count work and not time, so every machine gets the same results.

Each shard: gq check --plan plan.json --shard 3 --out results, from the directory in which the plan was made. Shards count from 0;
--shard 4/8 counts from 1, and --shard auto takes the number from the system that runs it. Then: gq merge results --plan plan.json.

--for solve, difficulty or verify plans that command instead: gq solve --plan plan.json --shard 3 --out results. Paths of verify are
plays: .gqr, directories of them, .ndjson with a play a line, .tar of .gqr; their levels and a challenge key must stay as they are.

Exit code: 0 when the plan was written; 2 when it was not.

Examples:
  $ gq plan levels --shards 8
  $ gq plan 'packs/*.ndjson.gz' --shards 200 --solve --effort 5000000 -o plan.json
  $ gq plan packs/all.tar --shards 200 --solve --effort 5000000 --costs last-week/results
  $ gq plan plays.ndjson.gz --shards 50 --for verify --levels levels`,
};

export function declare(command: Command, finish: (result: CommandResult) => void): void {
  addSearchOptions(addConfigOptions(addTermsOptions(command, accuracyOption('any'))), ' for each level')
    .argument(
      '[path...]',
      `${PATHS}; packs: .ndjson with a level a line, .tar of level files, also as .gz or .zst; with --for verify, plays`,
    )
    .requiredOption(
      '--shards <n>',
      'how many parts; a few for each processor, so that a slow one does not keep all waiting',
      wholeNumberOption('a number of shards', 1, MOST_SHARDS),
    )
    .option('-o, --output <file>', 'the plan', 'plan.json')
    .addOption(new Option('--for <command>', 'the command that each shard runs').choices(JOBS).default('check'))
    .option('--costs <report>', 'what levels have cost before: a directory of results, or a JSON report of gq check')
    .option('--force', 'replace a plan that is there')
    .option('--solve', 'check: search for a run where none in the file completes the level')
    .option(
      '--require-slack <ticks>',
      'check: require that every run forgives errors of TICKS',
      wholeNumberOption('a number of ticks', 0, 60),
    )
    .option('--no-require-slack', 'check: require no slack, whatever the configuration says')
    .option('--max-warnings <n>', 'check: fail when there are more warnings', wholeNumberOption('a number of warnings', 0, 1e9))
    .option('--brief', 'check: leave runs out of the report, which makes it much smaller')
    .addOption(prefixed('solve, difficulty', mineralsOption()))
    .addOption(prefixed('solve', objectiveOption()))
    .option('--count <n>', 'solve: how many clearly different runs to find', wholeNumberOption('a number of runs', 1, 100), 1)
    .option('--run <name>', 'difficulty: the run to measure (default: the first that completes a level, or one that is found)');
  addPlayOptions(command, 'verify: ').action(async (paths: string[], options: Options) =>
    finish(await plan(paths, options, command)),
  );
}

/** Says in the help of an option which commands have it. */
function prefixed(commands: string, option: Option): Option {
  option.description = `${commands}: ${option.description}`;
  return option;
}

async function plan(paths: readonly string[], options: Options, command: Command): Promise<CommandResult> {
  const { output, force = false, shards } = options;
  refuseOfOthers(options.for, command);
  const configuration = await readConfiguration(options);
  if (options.for === 'verify' && paths.length === 0)
    throw new Failure('expected the paths of plays: .gqr files, directories of them, or packs');
  const { settings, report, messages = '' } = await ORDERS[options.for](options, configuration, command);
  const costs = options.costs === undefined ? null : readCosts(options.costs);
  const line = createStatusLine();
  let made: Awaited<ReturnType<typeof makePlan>>;
  try {
    made = await makePlan(
      {
        job: options.for,
        paths: [...pathsOr(paths, configuration)],
        ignore: ignoreFor(configuration),
        settings: settings as Record<string, unknown>,
        report,
        shards,
        costs,
      },
      (levels) => line.show(`read ${levels} ${contentsOf(options.for)}`),
    );
  } finally {
    line.clear();
  }
  const text = planText(made.plan);
  expectReplaceable(output, text, force);
  await writeWhole(output, text);
  return { messages: messages + inWords(output, options, made), exitCode: 0 };
}

/** @throws Failure if another file is there that is not to be replaced */
function expectReplaceable(output: string, text: string, force: boolean): void {
  const stats = statOrError(output);
  // a device is written to as it is
  if (stats instanceof Error || !stats.isFile()) return;
  const there = Buffer.from(readRegularFile(output, Buffer.byteLength(text))).toString();
  const isPlan = /^\{\s*"gq":\s*"plan"/.test(there);
  if (there === text || (force && isPlan)) return;
  const advice = isPlan
    ? 'choose another -o, or replace it with --force'
    : `${force ? '--force replaces only plans, and this is none: ' : ''}choose another -o`;
  throw new Failure(`${namedPath(output)}: another file is there, and nothing was overwritten: ${advice}`);
}

function inWords(output: string, options: Options, { plan, balanced }: Awaited<ReturnType<typeof makePlan>>): string {
  const what = contentsOf(plan.job) === 'plays' ? 'play' : 'level';
  const counts = plan.shards.map(({ levels }) => levels);
  const [least, most] = [Math.min(...counts), Math.max(...counts)];
  const each = least === most ? `${least} each` : `${least} to ${most} each`;
  let words = `wrote ${namedPath(output)}: ${plural(plan.levels, what)} in ${plural(counts.length, 'shard')}, ${each}\n`;
  if (balanced !== null) {
    const total = balanced.expected.reduce((sum, ms) => sum + ms, 0);
    const slowest = Math.max(...balanced.expected);
    const over = total === 0 ? 0 : (100 * slowest * counts.length) / total - 100;
    words += `by what ${balanced.known} of them have cost, the slowest shard takes ${(slowest / 1000).toFixed(1)} s in one thread, ${over.toFixed(1)} % more than the mean\n`;
  }
  const empty = counts.filter((count) => count === 0).length;
  if (empty > 0) words += `${plural(empty, 'shard')} ${empty === 1 ? 'has' : 'have'} no ${what}: fewer shards do the same\n`;
  const last = counts.length - 1;
  return `${words}next: gq ${options.for} --plan ${shellPath(output)} --shard N --out results, N from 0 to ${last}; then gq merge results --plan ${shellPath(output)}\n`;
}
