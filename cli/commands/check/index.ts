import { availableParallelism } from 'node:os';
import type { Command } from 'commander';
import { addCacheOptions, type CacheOptions, cacheFolder, chosenCache } from '../../cache/index.ts';
import {
  type AskedOptions,
  type CheckedLevel,
  type CheckSettings,
  checkContent,
  checkFiles,
  exitCodeFor,
  exitCodeOf,
  FEW_FILES,
  judgeLevels,
  judgeOf,
  openLevelCache,
  refuseLimitsWithoutSearch,
  SOFTLOCK_EFFORT,
  settingsFor,
  tooManyWarnings,
  totalsOf,
  unreadableLevel,
} from '../../check/index.ts';
import type { CommandHelp, CommandResult } from '../../command.ts';
import { addConfigOptions, type ConfigOptions, type Configuration, readConfiguration } from '../../config/index.ts';
import { PATHS, pathsOr, unreadableFolders } from '../../find/index.ts';
import { type FoundPack, firstPack, levelsRead, STDIN } from '../../io/index.ts';
import {
  addSearchOptions,
  addShardOptions,
  addTermsOptions,
  jobsOption,
  refuseBesidesPlan,
  refuseUnused,
  type ShardOptions,
  wholeNumberOption,
} from '../../options/index.ts';
import type { CheckedPack } from '../../pack-file/index.ts';
import {
  chooseReports,
  expectReportFiles,
  forceReportsOption,
  reportCheck,
  reporterOption,
  reportFormatOption,
} from '../../reporters/index.ts';
import { editorLinkTo, editorUrlOption } from '../../show-failure/index.ts';
import { createProgress, exitCodeAfter, Failure } from '../../terminal/index.ts';
import { chooseFiles, refuseForPacks } from './choose-files.ts';

const MOST_WARNINGS = 1_000_000;

interface CheckOptions extends ConfigOptions, AskedOptions, CacheOptions, ShardOptions {
  readonly maxWarnings?: number;
  readonly quiet?: true;
  readonly format?: string;
  readonly reporter?: readonly string[];
  readonly force?: true;
  readonly jobs: number;
  /** false with --no-lock */
  readonly lock?: string | false;
  readonly updateLock?: true;
  readonly bail?: number;
  readonly changed?: true | string;
  readonly stdinPath?: string;
  readonly editorUrl?: string;
  readonly watch?: true;
}

export const help: CommandHelp = {
  description: 'Read and validate every level, replay its runs, and report which levels can be completed.',
  more: `
A directory stands for every *.level.json below it, except in hidden directories and node_modules. A file is read whatever its
name is. Verdicts: completable; broken (it has runs, and none completes it); unproven (no run shows that it can be completed);
impossible (it is proved that nobody can complete it); invalid; crashed. A level that costs more work than --max-work allows is
unproven. Work is counted, so it is the same on every machine; with the default, the check of any file ends within seconds.
A pack.json in a directory says in which order its levels are played: the report has them in that order, and problems of the list.
gq.config.json sets defaults of these options and the severity of problems, and a level can allow a problem: see
docs/configuration.md. --budget, --effort and --seed are for --solve. Proofs that nobody can collect a mineral are attempted with --solve, or when at
most ${FEW_FILES} files are checked. When a signal ends a check with --solve or --require-slack, what is checked until then is reported.

--lock and --update-lock measure certified ticks and the hash of each run, which takes about four times as long as the check
alone. A level without an entry in the lock fails; an entry whose level is gone is only said. --update-lock keeps the entries of
levels that are not checked, and writes nothing when the check ends early.
--changed asks git: levels that have changed since the history left that of REF count, whether committed, staged, renamed or new;
ignored files do not. REF is a branch, a tag or a commit. Without it, that is what GitHub and GitLab tell: the branch into which a
pull request goes, or the commit before a push; else origin/HEAD, main or master, else the last commit. In a job where nothing
tells what has changed, all levels are checked; where the clone ends too early, the exit code is 2. A changed configuration may change every result, so then all levels are
checked, and so are levels whose entry in the lock has changed. If no level has changed, nothing needs a check: the exit code is 0. A path that matches no level file stays an error.
--watch prints the reports of levels that have changed and the summary of all; other levels keep their reports. A changed
gq.config.json or lock counts for all levels. With --format json, each round prints one line.
--bail counts in the order of the files: the report ends with the Nth level that fails, for any number of threads.

Exit code: 2 when a path matches nothing (then nothing is checked), or when a file could not be read or gq failed on it (the
other levels are still reported); otherwise 1 when a level is not completable or has an error, such as a run that forgives less than
--require-slack, or when there are more warnings than --max-warnings; otherwise 0.

Examples:
  $ gq check                             every level under levels/
  $ gq check levels extra/a.level.json   a directory and a file
  $ gq check --solve --budget 30 drafts  search for runs, at most half a minute for each level
  $ gq check --require-slack 2           for CI: every run forgives errors of 33 ms
  $ gq check --softlocks --format json   places from which the black hole can't be reached any more
  $ gq check --lock gq.lock.json         compare with what was agreed on; --update-lock agrees anew
  $ gq check levels --changed            only what this branch changes; --changed=HEAD: what is not committed
  $ gq check --watch                     check again whenever a level is saved
  $ gq check - < a.level.json            a level from standard input
  $ gq check --bail 1                    stop at the first level that fails
  $ gq check --format json | jq .summary
  $ gq check --format github             annotations for a pull request
  $ gq check --reporter github --reporter json=out/levels.json   a report on stdout, and one in a file`,
};

export function declare(command: Command, finish: (result: CommandResult) => void): void {
  addShardOptions(addCacheOptions(addSearchOptions(addConfigOptions(addTermsOptions(command)), ' for each level')))
    .argument('[path...]', PATHS)
    .option('--solve', 'search for a run where none in the file completes the level, and warn of runs that forgive no error')
    .option(
      '--require-slack <ticks>',
      'require that every run that completes a level still does when all its presses and releases are off by up to TICKS',
      wholeNumberOption('a number of ticks', 0, 60),
    )
    .option(
      '--softlocks [ticks]',
      `find where a level is already lost although she lives on, with an effort of TICKS for each level (default: ${SOFTLOCK_EFFORT})`,
      wholeNumberOption('a number of ticks', 1, Number.MAX_SAFE_INTEGER),
    )
    .option('--no-require-slack', 'require no slack, whatever the configuration says')
    .option(
      '--max-warnings <n>',
      'fail when there are more warnings than this (default: any number is allowed)',
      wholeNumberOption('a number of warnings', 0, MOST_WARNINGS),
    )
    .option('--quiet', 'show only errors and the summary (pretty and github); warnings still count')
    .addOption(reportFormatOption())
    .addOption(reporterOption())
    .addOption(forceReportsOption())
    .addOption(editorUrlOption())
    .addOption(jobsOption(availableParallelism()))
    .option('--lock <file>', 'compare the results with those agreed on in this file; a difference is the error result-changed')
    .option('--no-lock', 'compare with no lock, whatever the configuration says')
    .option('--update-lock', 'agree anew: write the results into the lock file (default: gq.lock.json)')
    .option('--changed [ref]', 'check only levels that differ from REF (default: from the branch that changes go into)')
    .option('-w, --watch', 'check again what has changed, until q or Ctrl-C')
    .option('--stdin-path <file>', 'with the path -: the name in reports of the level that is read from standard input')
    .option('--bail <n>', 'check no more levels after N have failed', wholeNumberOption('a number of levels', 1, 1e6))
    .action(async (paths: string[], options: CheckOptions) => {
      refuseBesidesPlan(command, paths, options);
      if (options.plan !== undefined) {
        // a plan is read with the schema, which a check leaves to its workers
        const { shardOfPlan } = await import('../../fleet/index.ts');
        return finish(await shardOfPlan('check', options, options.jobs));
      }
      refuseUnused(command, [{ option: '--seed', isUsed: options.solve === true, needs: '--solve' }]);
      finish(await (options.watch ? watchLevels(paths, options) : check(paths, options, checkFiles)));
    });
}

async function watchLevels(paths: readonly string[], options: CheckOptions): Promise<CommandResult> {
  refuseToWatch(paths, options);
  const { Memory, watchAndRepeat } = await import('../../watch/index.ts');
  const memory = new Memory();
  const configuration = await readConfiguration(options);
  const lock = options.lock ?? configuration.lock;
  return watchAndRepeat({
    paths: pathsOr(paths, configuration),
    files: [lock, configuration.file].filter((file) => typeof file === 'string'),
    forget: () => memory.forget(),
    round: () => memory.round(() => check(paths, options, memory.remembering(checkFiles), (levels) => memory.newOf(levels))),
  });
}

function refuseToWatch(paths: readonly string[], { updateLock }: CheckOptions): void {
  if (updateLock) throw new Failure('--update-lock agrees on one result of each level: expected no --watch with it');
  const pack = firstPack(paths);
  if (pack !== undefined) refuseForPacks(pack, { watch: true, lock: null });
  if (paths.includes(STDIN)) throw new Failure('--watch follows files: expected no level from standard input with it');
}

async function check(
  paths: readonly string[],
  options: CheckOptions,
  checkThem: typeof checkFiles,
  shown: (levels: readonly CheckedLevel[]) => ReadonlySet<string> | undefined = () => undefined,
): Promise<CommandResult> {
  refuseLimitsWithoutSearch(options);
  const configuration = await readConfiguration(options);
  const configured = configuration.reporters?.map(({ name, file }) => (file === null ? name : `${name}=${file}`));
  const reports = chooseReports({ ...options, configured });
  const named = firstPack(paths);
  if (named !== undefined) refuseForPacks(named, { ...options, lock: null });
  const {
    files,
    all,
    packs: found,
    unreadable,
    input,
    message,
  } = await chooseFiles(
    paths,
    { ...options, lock: options.lock || undefined, comparedLock: (options.lock ?? configuration.lock) || null },
    configuration,
  );
  // a level from standard input without a name is in no lock
  const configuredLock = input !== null && options.stdinPath === undefined ? null : configuration.lock;
  const lockFile = (options.lock ?? configuredLock) || (options.updateLock ? 'gq.lock.json' : null);
  const inputs = { ...levelsRead(files, 'checked'), 'the lock': lockFile, 'the configuration': configuration.file };
  expectReportFiles(reports, { ...inputs, 'the order of a pack': found.map(({ file }) => file) }, options.force === true);
  const pack = input === null ? firstPack(files) : undefined;
  if (pack !== undefined) refuseForPacks(pack, { ...options, lock: lockFile });
  const asked = settingsFor(options, configuration, files.length);
  const { terms } = asked;
  const lock =
    lockFile === null
      ? null
      : (await import('../../lock/index.ts')).openComparison({
          file: lockFile,
          update: options.updateLock === true,
          terms,
          paths: input === null ? pathsOr(paths, configuration) : files,
          levels: files,
        });
  const compare = (levels: readonly CheckedLevel[]): readonly CheckedLevel[] => lock?.compare(levels) ?? levels;
  const settings: CheckSettings = {
    ...asked,
    forLock: lock !== null,
    inFull: reports.some(({ name }) => name === 'json'),
  };
  const linkTo = editorLinkTo(options.editorUrl);
  const maxWarnings = options.maxWarnings ?? configuration.maxWarnings;
  if (pack !== undefined) {
    if (unreadable.length > 0) throw unreadableFolders(unreadable);
    const reporting = { terms, severity: configuration.severity, maxWarnings };
    const { jobs, quiet } = options;
    // most checks have no packs
    const { reportWhole } = await import('../../fleet/index.ts');
    const asSet = { ...settings, proveMinerals: options.solve === true };
    return reportWhole('check', asSet, files, reports, 'checked', { jobs, reporting, quiet, linkTo });
  }
  const folder = cacheFolder(chosenCache(options, configuration.cache));
  const cache = folder === null ? null : openLevelCache(folder, settings);
  const progress = createProgress('checked', files.length);
  const bail = options.bail === undefined ? null : { most: options.bail, fails: await failsFor(configuration, compare) };
  const {
    levels: checked,
    unchecked,
    signal,
  } = input === null
    ? await checkThem(files, settings, options.jobs, progress.update, { bail, cache })
    : { levels: [await checkContent(files[0], input, settings)], unchecked: [], signal: null };
  progress.clear();
  const isWhole = signal === null && unchecked.length === 0 && unreadable.length === 0;
  const messages = await lock?.end(checked, isWhole);
  const every = [...checked];
  for (const { path, reason } of unreadable)
    every.push(unreadableLevel(path, `${path}: the directory can't be read: ${reason}`, terms));
  // severity, what levels allow and the lock do not change what was checked and kept
  const levels = await judgeLevels(compare(every), configuration);
  const packs = await checkedPacks(found, all, configuration);
  const totals = totalsOf(levels, packs);
  const results = {
    levels,
    packs,
    totals,
    unchecked,
    interrupted: signal !== null,
    shown: shown(levels),
    excess: tooManyWarnings(totals, maxWarnings),
  };
  const isNothing = levels.length === 0 && options.changed !== undefined;
  const exitCode =
    signal !== null ? exitCodeAfter(signal) : isNothing ? exitCodeOfPacks(packs) : exitCodeFor(totals, maxWarnings);
  const hasNews = !isNothing || packs.some(({ problems }) => problems.length > 0);
  const reported = hasNews ? reports : reports.filter(({ name }) => name !== 'pretty');
  const report = await reportCheck(results, reported, {
    exitCode,
    terms,
    linkTo,
    quiet: options.quiet,
  });
  return { ...report, messages: `${message}${report.messages ?? ''}${messages ?? ''}` };
}

/** Checks the pack files of a check. They are read even if no level has changed: a list says something about all levels. */
async function checkedPacks(
  found: readonly FoundPack[],
  files: readonly string[],
  { rules, severity }: Configuration,
): Promise<readonly CheckedPack[]> {
  if (found.length === 0) return [];
  const { checkPackFile } = await import('../../pack-file/index.ts');
  const kept = new Set(files);
  return found.map((pack) => checkPackFile(pack, kept, { rules, severity }));
}

/** The exit code where nothing but packs is checked. */
const exitCodeOfPacks = (packs: readonly CheckedPack[]): 0 | 1 | 2 => {
  if (packs.some(({ unreadable }) => unreadable)) return 2;
  return packs.some(({ problems }) => problems.some(({ severity }) => severity === 'error')) ? 1 : 0;
};

/** Whether a level alone makes a check fail. */
async function failsFor(
  configuration: Configuration,
  compare: (levels: readonly CheckedLevel[]) => readonly CheckedLevel[],
): Promise<(level: CheckedLevel) => boolean> {
  const judge = await judgeOf(configuration);
  return (level) => exitCodeOf(compare([level]).map(judge), null) > 0;
}
