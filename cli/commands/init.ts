import { relative } from 'node:path';
import { type Command, Option } from 'commander';
import type { InitReport } from '../../schema/index.ts';
import type { CommandHelp, CommandResult } from '../command.ts';
import { type Ci, chooseCi, type Plan, planProject } from '../init/index.ts';
import { planFile, writeAll } from '../io/index.ts';
import { formatOption } from '../options/index.ts';
import { shellPath, visibleLine } from '../terminal/index.ts';

interface InitOptions {
  readonly ci?: Ci;
  readonly dryRun?: true;
  readonly format: 'pretty' | 'json';
}

/** No file that is merged is larger, bytes. */
const LARGEST = 8 * 1024 * 1024;

export const help: CommandHelp = {
  description: 'Put levels, configuration, a workflow for CI and settings of the editor into a project.',
  more: `
Writes what is missing, and asks nothing: two levels with runs, gq.config.json, a workflow, a script "check" in package.json, and
the schemas in .vscode/settings.json. A file that exists is never overwritten: a script or a setting is added where it is missing,
and everything else is left and listed. A second time it changes nothing. Writes either every file or none.

Exit code: 0; 2 when a file could not be read or written.

Examples:
  $ gq init
  $ gq init games/one --ci gitlab
  $ gq init --dry-run`,
};

export function declare(command: Command, finish: (result: CommandResult) => void): void {
  command
    .argument('[dir]', 'the folder of the project; it is created when missing', '.')
    .addOption(
      new Option('--ci <name>', 'where levels are checked (default: what the repository uses, else github)').choices([
        'github',
        'gitlab',
        'none',
      ]),
    )
    .option('--dry-run', 'only say what would be written')
    .addOption(formatOption('pretty', 'json'))
    .action(async (directory: string, options: InitOptions) => finish(await init(directory, options)));
}

async function init(directory: string, options: InitOptions): Promise<CommandResult> {
  const ci = options.ci ?? chooseCi(directory);
  const plan = planProject(directory, ci);
  const { files } = plan;
  const wanted = files.flatMap(({ file, text }) => (text === null ? [] : [planFile(file, text, 'gq init', LARGEST)]));
  if (!options.dryRun) await writeAll(wanted);
  const statuses = new Map(wanted.map(({ file, status }) => [file, status]));
  const done = files.map(({ file, note = null }): InitReport['files'][number] => {
    const status = statuses.get(file);
    const name = relative('', file) || '.';
    return { file: name, status: status === undefined ? 'left' : status === 'overwritten' ? 'changed' : status, note };
  });
  const report: InitReport = {
    version: 1,
    dryRun: options.dryRun === true,
    ci,
    files: done,
    next: nextSteps(directory, plan),
  };
  return { output: options.format === 'json' ? initJson(report) : initPretty(report), exitCode: 0 };
}

function nextSteps(directory: string, { isInstalled, isRepository }: Plan): string[] {
  const inside = relative('', directory);
  return [
    ...(inside === '' ? [] : [`cd ${shellPath(inside)}`]),
    ...(isInstalled
      ? []
      : ['npm install --save-dev PACKAGE, where PACKAGE is the tarball or the address of gravity-quest-toolkit']),
    'npx gq check',
    'npx gq edit levels',
    ...(isRepository ? ['npx gq git-setup, so that git merges and compares levels with gq'] : []),
  ];
}

/** The results of `init` as JSON. */
const initJson = (report: InitReport): string => `${JSON.stringify(report)}\n`;

const WOULD = { written: 'would write', changed: 'would change', unchanged: 'unchanged', left: 'left' };

/** The results of `init` for people. */
function initPretty({ dryRun, files, next }: InitReport): string {
  const lines = files.map(({ file, status, note }) => {
    const words = dryRun ? WOULD[status] : status;
    return `${words} ${visibleLine(file)}${note === null ? '' : `: ${note}`}`;
  });
  const steps = next.map((step) => `  ${visibleLine(step)}`);
  return `${lines.join('\n')}\n\n${dryRun ? 'nothing was written; afterwards' : 'next'}:\n${steps.join('\n')}\n`;
}
