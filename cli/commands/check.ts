import { availableParallelism } from 'node:os';
import process from 'node:process';
import type { Command } from 'commander';
import { type AccuracyOptions, addAccuracyOptions, chooseAccuracy } from '../accuracy-options.ts';
import { checkFiles } from '../check/check-files.ts';
import type { CheckedLevel } from '../check/checked-level.ts';
import { unreadableLevel } from '../check/refused-level.ts';
import { exitCodeOf } from '../check/summary.ts';
import { colorsFor } from '../colors.ts';
import type { CommandResult } from '../command.ts';
import { findLevelFiles } from '../files.ts';
import { formatOption, maxTimeOption, wholeNumberOption } from '../options.ts';
import { createProgress } from '../progress.ts';
import { checkGithub } from '../reporters/check-github.ts';
import { checkJson } from '../reporters/check-json.ts';
import { checkPretty } from '../reporters/check-pretty.ts';

interface CheckOptions extends AccuracyOptions {
  readonly maxTime: number;
  readonly format: 'pretty' | 'json' | 'github';
  readonly jobs: number;
}

export function declare(command: Command, finish: (result: CommandResult) => void): void {
  addAccuracyOptions(command)
    .description('Read, validate and replay every level, and say which can be completed.')
    .argument('[path...]', 'level files, directories, or quoted patterns with * ** ?', ['levels'])
    .addOption(maxTimeOption())
    .addOption(formatOption('pretty', 'json', 'github'))
    .option('-j, --jobs <n>', 'worker threads at most', wholeNumberOption('a number of threads', 1, 256), availableParallelism())
    .addHelpText(
      'after',
      `
A directory stands for every *.level.json below it (hidden directories and node_modules left out); a file is read whatever
its name. Verdicts: completable, broken (it has runs, none completes it), unproven (no run), invalid, crashed.

Exit code: 2 when a path matches nothing (then nothing is checked), or when a file could not be read or gq failed on it
(the other levels are reported all the same); else 1 when a level is anything but completable; else 0.

Examples:
  $ gq check                             every level under levels/
  $ gq check levels extra/a.level.json   a directory and a file
  $ gq check --format json | jq .summary
  $ gq check --format github             annotations for a pull request`,
    )
    .action(async (paths: string[], options: CheckOptions) => finish(await check(paths, options)));
}

async function check(paths: readonly string[], options: CheckOptions): Promise<CommandResult> {
  const settings = { accuracy: chooseAccuracy(options), maxTime: options.maxTime, inFull: options.format === 'json' };
  const { files, unreadable } = await findLevelFiles(paths);
  const progress = createProgress('checked', files.length);
  const reports: CheckedLevel[] = await checkFiles(files, settings, options.jobs, progress.update);
  progress.clear();
  for (const { path, reason } of unreadable) reports.push(unreadableLevel(path, `${path}: can't be looked into: ${reason}`));
  return { output: report(reports, options.format), exitCode: exitCodeOf(reports) };
}

function report(reports: readonly CheckedLevel[], format: CheckOptions['format']): string {
  switch (format) {
    case 'json':
      return checkJson(reports);
    case 'github':
      return checkGithub(reports);
    case 'pretty':
      return checkPretty(reports, colorsFor(process.stdout));
  }
}
