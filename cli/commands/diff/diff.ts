import { availableParallelism } from 'node:os';
import process from 'node:process';
import type { Command } from 'commander';
import { type AccuracyOptions, addAccuracyOptions, chooseAccuracy } from '../../accuracy-options.ts';
import { colorsFor } from '../../colors.ts';
import type { CommandResult } from '../../command.ts';
import { chooseComparison, diffFiles } from '../../diff/index.ts';
import { formatOption, jobsOption, maxTimeOption } from '../../options.ts';
import { visible } from '../../visible.ts';
import { diffJson } from './json.ts';
import { diffText } from './text.ts';

interface Options extends AccuracyOptions {
  readonly staged?: true;
  readonly exitCode?: true;
  readonly slack: boolean;
  readonly format: 'text' | 'json';
  readonly maxTime: number;
  readonly jobs: number;
}

export function declare(command: Command, finish: (result: CommandResult) => void): void {
  addAccuracyOptions(
    command
      .description(
        'Show what changed in levels: objects by id, runs by name, and what that does to verdict, time, slack and minerals.',
      )
      .argument('[words...]', 'up to two revisions, then level files, folders or quoted patterns; or two files; or two folders')
      .usage('[options] [REF [REF]] [--] [PATH...]')
      .option('--staged', 'compare what is staged for the next commit, and not the working tree')
      .option('--exit-code', 'end with 1 if any level file differs')
      .option('--no-slack', 'do not measure how far presses and releases can move, which takes most of the time'),
  )
    .addOption(formatOption('text', 'json'))
    .addOption(maxTimeOption())
    .addOption(jobsOption(availableParallelism()))
    .addHelpText(
      'after',
      `
Without REF the working tree, untracked level files included, is compared with HEAD; with one REF, with that; with two, or
REF..REF, the second is compared with the first. REF...REF compares the second with the commit where both parted.

Exit code: 0; with --exit-code 1 if a level file differs; 2 when the comparison could not be made.

Examples:
  $ gq diff                          what changed since the last commit
  $ gq diff main...feature levels    what a branch changes
  $ gq diff old.level.json new.level.json`,
    )
    .action(async (words: string[], options: Options) => finish(await diff(words, command, options)));
}

/** Divides the arguments at `--`, which commander leaves out. */
function divided(words: readonly string[], command: Command): { words: readonly string[]; paths: readonly string[] | null } {
  // what `parseAsync` of the whole program was given
  const { rawArgs } = (command.parent ?? command) as unknown as { readonly rawArgs: readonly string[] };
  const at = rawArgs.indexOf('--');
  if (at < 0) return { words, paths: null };
  const count = rawArgs.length - at - 1;
  return { words: words.slice(0, words.length - count), paths: words.slice(words.length - count) };
}

async function diff(words: readonly string[], command: Command, options: Options): Promise<CommandResult> {
  const { maxTime, slack, jobs, format } = options;
  const settings = { accuracy: chooseAccuracy(options), maxTime, slack };
  const comparison = await chooseComparison({ ...divided(words, command), staged: options.staged === true });
  const result = await diffFiles(comparison, settings, jobs);
  const exitCode = options.exitCode && result.levels.length > 0 ? 1 : 0;
  const messages = comparison.messages.map((message) => `${visible(message)}\n`).join('');
  const output = format === 'json' ? diffJson(result) : diffText(result, colorsFor(process.stdout));
  return { output, messages, exitCode };
}
