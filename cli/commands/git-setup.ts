import { type Command, Option } from 'commander';
import type { CommandHelp, CommandResult } from '../command.ts';
import { missing, type OnBrokenRun, setUp, undo } from '../git-setup/index.ts';
import { Failure, visibleLine } from '../terminal/index.ts';

interface Options {
  readonly undo?: true;
  readonly check?: true;
  readonly onBrokenRun?: OnBrokenRun;
}

export const help: CommandHelp = {
  description:
    'Tell git to merge and compare level files with gq: settings of this clone, and a line in .gitattributes to commit.',
  more: `
Every clone needs it once; running it again changes nothing. Clones without it merge levels as text.

Exit code: 0; 1 with --check when something is missing; 2 when there is no working tree, or git could not be used.`,
};

export function declare(command: Command, finish: (result: CommandResult) => void): void {
  command
    .option('--check', 'only say whether it is set up')
    .option('--undo', 'take back what this command has done')
    .addOption(
      new Option(
        '--on-broken-run <what>',
        'when no run completes a merged level any more: stop the merge for a look (default), or only warn',
      ).choices(['stop', 'warn']),
    )
    .action(async (options: Options) => finish(await gitSetup(options)));
}

const lines = (all: readonly string[]): string => all.map((line) => `${visibleLine(line)}\n`).join('');

async function gitSetup({ undo: isUndo, check, onBrokenRun }: Options): Promise<CommandResult> {
  if (check && isUndo) throw new Failure('--check only looks, and --undo changes: give one of them');
  if (onBrokenRun !== undefined && (check || isUndo)) throw new Failure('--on-broken-run is for setting up: leave it out');
  if (check) {
    const lacking = missing();
    if (lacking.length === 0) return { output: 'git merges and compares levels with gq\n', exitCode: 0 };
    return { output: lines([...lacking, 'to set it up: gq git-setup']), exitCode: 1 };
  }
  if (isUndo) {
    const done = await undo();
    return { output: lines(done.length > 0 ? done : ['nothing to undo']), exitCode: 0 };
  }
  const done = await setUp(onBrokenRun ?? 'stop');
  const lacking = missing();
  const ready = lacking.length > 0 ? lacking : ['git merges and compares levels with gq'];
  return { output: lines([...done, ...ready]), exitCode: lacking.length > 0 ? 1 : 0 };
}
