import { mkdtempSync } from 'node:fs';
import { tmpdir } from 'node:os';
import { basename, join } from 'node:path';
import process from 'node:process';
import { pathToFileURL } from 'node:url';
import type { Command } from 'commander';
import type { CommandHelp, CommandModule, CommandResult } from '../../command.ts';
import { compareFiles, type Diff, type DiffSettings, diffFiles, playVersions, termsOfSides } from '../../diff/index.ts';
import { writeWhole } from '../../io/index.ts';
import { colorsFor, Failure, visibleLine } from '../../terminal/index.ts';
import { diffText } from './text.ts';

interface Options {
  readonly open: boolean;
}

const help: CommandHelp = {
  description:
    'Show two versions of a level in the browser: what changed, and both runs on one stage. Called with the seven arguments of an external diff of git, print what changed instead.',
  more: `
The levels are judged under the terms of the gq.config.json that is nearest to PATH.
The page is written to the folder for temporary files. Where there is no display, its path is printed.

Exit code: 0; 2 when a file could not be read.

Examples:
  $ gq difftool old.level.json new.level.json
  $ git config difftool.gq.cmd 'gq difftool "$LOCAL" "$REMOTE" "$MERGED"'
  $ git difftool --tool gq`,
};

function declare(command: Command, finish: (result: CommandResult) => void): void {
  command
    .argument('<files...>', 'LOCAL REMOTE [PATH]: the two versions, and the name that the file has in the repository')
    .usage('[options] LOCAL REMOTE [PATH]')
    .option('--no-open', 'only write the page, and print its path')
    .action(async (files: string[], options: Options) => finish(await compareVersions(files, options)));
}

/** `gq difftool`, beside `gq diff`. */
export const difftool: CommandModule = { help, declare };

async function compareVersions(files: readonly string[], { open }: Options): Promise<CommandResult> {
  switch (files.length) {
    case 1:
      // so git calls an external diff for a file that is not merged
      return { output: `* unmerged ${visibleLine(files[0])}\n`, exitCode: 0 };
    case 2:
    case 3:
      return show(files, open);
    case 7:
    case 9: {
      const [path, before, , , after] = files;
      return { output: diffText((await compare(before, after, files[7] ?? path)).diff, colorsFor(process.stdout)), exitCode: 0 };
    }
    default:
      throw new Failure(
        `expected LOCAL REMOTE [PATH], or the 7 or 9 arguments of an external diff of git, found ${files.length}`,
      );
  }
}

/** Compares two versions under the terms of the folder. */
async function compare(
  before: string,
  after: string,
  name: string | undefined,
): Promise<{ readonly diff: Diff; readonly settings: DiffSettings }> {
  const comparison = await compareFiles(before, after, name);
  const settings = { terms: termsOfSides(comparison, {}), slack: true };
  return { diff: await diffFiles(comparison, settings, 1), settings };
}

async function show([before, after, path]: readonly string[], open: boolean): Promise<CommandResult> {
  const { diff, settings } = await compare(before, after, path);
  const name = path ?? after;
  const { diffPage } = await import('./page.ts');
  const page = diffPage(diff, (i) => playVersions(diff.pairs[i], diff.levels[i], settings));
  const folder = mkdtempSync(join(tmpdir(), 'gq-diff-'));
  const file = join(folder, `${basename(name).replace(/[^\w.-]/g, '_')}.html`);
  await writeWhole(file, page);
  if (!open || !hasDisplay()) return { output: `${file}\n`, exitCode: 0 };
  const failure = await opened(pathToFileURL(file).href);
  if (failure === null) return { exitCode: 0 };
  return { output: `${file}\n`, messages: `the browser could not be opened (${failure}): open the page yourself\n`, exitCode: 0 };
}

/** Whether a browser can show anything. */
function hasDisplay(): boolean {
  const { DISPLAY, WAYLAND_DISPLAY, WSL_DISTRO_NAME, BROWSER } = process.env;
  const isLinux = process.platform !== 'darwin' && process.platform !== 'win32';
  return !isLinux || [DISPLAY, WAYLAND_DISPLAY, WSL_DISTRO_NAME, BROWSER].some((value) => value !== undefined && value !== '');
}

/** ms after which a browser that has not failed counts as open. */
const SOON = 1500;

/** Opens an address. @returns why it failed; null if it did not */
async function opened(address: string): Promise<string | null> {
  const { openBrowser } = await import('../../serve/index.ts');
  return new Promise((resolve) => {
    const timer = setTimeout(() => resolve(null), SOON);
    openBrowser(address, (why) => {
      clearTimeout(timer);
      resolve(why);
    });
  });
}
