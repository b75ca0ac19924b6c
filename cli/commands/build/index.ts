import { availableParallelism } from 'node:os';
import process from 'node:process';
import { gzipSync } from 'node:zlib';
import { type Command, InvalidArgumentError } from 'commander';
import { checkPack, findPack, GAME, packOf, planSite, readGame, refusedOf, siteFiles, writeSite } from '../../build/index.ts';
import { addCacheOptions, type CacheOptions, chosenCache } from '../../cache/index.ts';
import { type AskedOptions, refuseLimitsWithoutSearch } from '../../check/index.ts';
import type { CommandHelp, CommandResult } from '../../command.ts';
import { addConfigOptions, type ConfigOptions, readConfiguration } from '../../config/index.ts';
import { PATHS } from '../../find/index.ts';
import {
  accuracyOption,
  addSearchOptions,
  formatOption,
  jobsOption,
  maxTimeOption,
  maxWorkOption,
  refuseUnused,
} from '../../options/index.ts';
import { isFailing } from '../../show-failure/index.ts';
import { colorsFor, createProgress, exitCodeAfter } from '../../terminal/index.ts';
import { type BuildResult, buildJson, buildPretty, refusedInWords } from './report.ts';

interface Options extends AskedOptions, ConfigOptions, CacheOptions {
  readonly out: string;
  readonly title?: string;
  readonly force?: true;
  readonly overwrite?: true;
  /** false with --no-runs */
  readonly runs: boolean;
  readonly jobs: number;
  readonly format: 'pretty' | 'json';
}

/** characters; a longer title is a mistake */
const LONGEST_TITLE = 200;

function parseTitle(text: string): string {
  const title = text.trim();
  if (title !== '' && title.length <= LONGEST_TITLE && !/\p{Cc}/u.test(title)) return title;
  throw new InvalidArgumentError(`expected a line of 1 to ${LONGEST_TITLE} characters`);
}

export const help: CommandHelp = {
  description: 'Make a static page on which levels can be played one after the other, for any web server or none.',
  more: `
Checks every level as gq check does, with gq.config.json and the cache, and builds nothing when one is not completable or has an
error. --force builds all the same; an invalid level is never built. Locks and the number of warnings do not count here.
Levels are played in the order of the paths, and below each path by name, numbers by their value. Where a folder has a pack.json,
its levels are played as that lists them, with its chapters, and those that it does not list are left out. The rules of gq.config.json
become rules of each level, so that it plays the same.

The page needs no server: open index.html, or put the folder anywhere on any web server. It asks no other host for anything.
The same input gives the same bytes. A new folder appears complete or not at all; in an existing one, files that are not of the
last build stay, and --overwrite is needed to write over them or into a folder that gq build has not made.

Exit code: 0; 1 when a level is not completable, has an error or is not valid (nothing is written); 2 when a file could not be
read or written.

Examples:
  $ gq build levels --out site
  $ gq build levels --out site --title "My levels"
  $ gq build levels/07-slingshot.level.json --out slingshot
  $ gq build drafts --out site --force --no-runs`,
};

export function declare(command: Command, finish: (result: CommandResult) => void): void {
  addCacheOptions(addSearchOptions(addConfigOptions(command), ' for each level'))
    .argument('[path...]', PATHS)
    .requiredOption('--out <site>', 'folder for the page; it is created when missing')
    .option(
      '--title <text>',
      'title of the page (default: the name in pack.json, else that of the only level, else "Gravity Quest")',
      parseTitle,
    )
    .option('--force', 'build although levels are not known to be completable')
    .option('--overwrite', 'write over files in the folder that the last build has not written')
    .option('--no-runs', 'leave out the runs of the levels, which give their solutions away')
    .option('--solve', 'search for a run where none in the file completes the level; the page shows it')
    .addOption(accuracyOption())
    .addOption(maxTimeOption())
    .addOption(maxWorkOption())
    .addOption(jobsOption(availableParallelism()))
    .addOption(formatOption('pretty', 'json'))
    .action(async (paths: string[], options: Options) => {
      refuseUnused(command, [{ option: '--seed', isUsed: options.solve === true, needs: '--solve' }]);
      finish(await build(paths, options));
    });
}

async function build(paths: readonly string[], options: Options): Promise<CommandResult> {
  refuseLimitsWithoutSearch(options);
  const { out, title, force = false, overwrite = false, runs, jobs, format } = options;
  const configuration = await readConfiguration(options);
  const { files, order, leftOut } = await findPack(paths, configuration);
  const game = readGame(GAME);
  // what is wrong with the folder is known before the check, which may take long
  planSite(out, new Map(), overwrite);
  const progress = createProgress('checked', files.length);
  const pack = await checkPack(files, configuration, {
    asked: options,
    cache: chosenCache(options, configuration.cache),
    jobs,
    onProgress: progress.update,
  });
  progress.clear();
  const { levels, signal } = pack;
  if (signal !== null) return { messages: 'nothing was written: the check was interrupted\n', exitCode: exitCodeAfter(signal) };
  const shown = title ?? order?.name ?? (levels.length === 1 ? levels[0].name : 'Gravity Quest');
  const refused = refusedOf(pack, force);
  const result: BuildResult = { site: out, title: shown, levels, leftOut, refused, files: [], gzipped: 0 };
  if (refused.length > 0) {
    const messages = refusedInWords(pack, refused, { force, colors: colorsFor(process.stderr) });
    const isCrash = refused.some(({ verdict, unreadable }) => verdict === 'crashed' || unreadable);
    return { output: format === 'json' ? buildJson(result) : '', messages, exitCode: isCrash ? 2 : 1 };
  }
  const content = siteFiles(
    game,
    packOf(pack, { title: shown, rules: configuration.rules, withRuns: runs, chapters: order?.chapters ?? new Map() }),
  );
  const written = await writeSite(planSite(out, content, overwrite));
  const gzipped = [...content.values()].reduce((sum, bytes) => sum + gzipSync(bytes).length, 0);
  const done = { ...result, files: written, gzipped };
  const forced = levels.filter(isFailing);
  const messages = forced.length === 0 ? '' : refusedInWords(pack, forced, { force: 'built', colors: colorsFor(process.stderr) });
  return { output: format === 'json' ? buildJson(done) : buildPretty(done), messages, exitCode: 0 };
}
