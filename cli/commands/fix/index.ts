import process from 'node:process';
import type { Command } from 'commander';
import { proposalInWords } from '../../../check/words/index.ts';
import type { CommandHelp, CommandResult } from '../../command.ts';
import { addConfigOptions, type ConfigOptions, readConfiguration } from '../../config/index.ts';
import { expectWritable, type OpenedFile, openLevel, replaceLevel } from '../../levels/index.ts';
import {
  addSearchOptions,
  addTermsOptions,
  formatOption,
  limitsOf,
  type SearchOptions,
  type TermsOptions,
  termsFrom,
  wholeNumberOption,
} from '../../options/index.ts';
import { colorsFor, createStatusLine, Failure, uncut, visibleLine } from '../../terminal/index.ts';
import { type Fixed, type FixSettings, fixLevel } from './fixed.ts';
import { fixPretty, fixReport } from './report.ts';

interface Options extends ConfigOptions, TermsOptions, SearchOptions {
  readonly count: number;
  readonly write?: number | true;
  readonly format: 'pretty' | 'json';
}

const MOST_PROPOSALS = 20;
const proposalNumber = wholeNumberOption('the number of a proposal', 1, MOST_PROPOSALS);

export const help: CommandHelp = {
  description: 'Find the smallest change that makes a level completable: of the level, or only of a run.',
  more: `
One thing is changed at a time: an object is moved, made larger or smaller, or removed, the range or her velocity at the start is
changed, or only a run. A proof that the level is impossible says where to begin. Every proposal is replayed in the file as it
would be written. It is the smallest that was found, not the smallest that there is.

Exit code: 0 when there is a proposal, or nothing to fix; 1 when none was found, or the file is not a valid level; 2 when the level
could not be read or written; 130 and 143 after SIGINT and SIGTERM.

Examples:
  $ gq fix my.level.json
  $ gq fix my.level.json --write 2
  $ gq fix my.level.json --effort 5000000 --format json | jq '.proposals[].words'`,
};

export function declare(command: Command, finish: (result: CommandResult) => void): void {
  addSearchOptions(addConfigOptions(addTermsOptions(command)))
    .argument('<level>', 'a level file')
    .option(
      '--count <n>',
      'how many proposals of different kinds to give',
      wholeNumberOption('a number of proposals', 1, MOST_PROPOSALS),
      3,
    )
    .option('--write [n]', 'write proposal N, by default the first, to the level file', proposalNumber)
    .addOption(formatOption('pretty', 'json'))
    .action(async (file: string, options: Options) => finish(await fix(file, options)));
}

async function fix(file: string, options: Options): Promise<CommandResult> {
  const settings: FixSettings = {
    terms: termsFrom(options, await readConfiguration(options)),
    count: options.count,
    seed: options.seed,
    limits: limitsOf(options),
  };
  const wanted = options.write === true ? 1 : (options.write ?? null);
  if (wanted !== null && wanted > options.count) {
    throw new Failure(`--write ${wanted}: there are at most ${options.count} proposals: give --count ${wanted} as well`);
  }
  const opened = openLevel(file, settings.terms);
  if (!('level' in opened)) return opened;
  if (wanted !== null) expectWritable(file);
  const fixed = seek(opened, settings);
  const found = fixed.fixes.length > 0 || fixed.completing !== null;
  const report = (written: number | null): string =>
    options.format === 'json'
      ? `${JSON.stringify(fixReport(opened.level, settings, fixed, written))}\n`
      : fixPretty(opened.level, settings, fixed, colorsFor(process.stdout));
  const exitCode = found ? 0 : 1;
  if (wanted === null) return { output: report(null), exitCode };
  const chosen = fixed.fixes[wanted - 1];
  if (chosen === undefined) {
    const why = fixed.completing !== null ? 'there is nothing to fix' : `there is no proposal ${wanted}`;
    return { output: report(null), messages: `nothing was written: ${why}\n`, exitCode: fixed.completing !== null ? 0 : 1 };
  }
  try {
    await uncut(() => replaceLevel(file, opened.bytes, chosen.file, 'run gq fix again'));
    const messages = `wrote proposal ${wanted} to ${file}: ${proposalInWords(opened.level, chosen.proposal)}`;
    return { output: report(wanted), messages: `${visibleLine(messages)}\n`, exitCode };
  } catch (error) {
    if (!(error instanceof Failure)) throw error;
    // the proposals are reported even if none can be written
    return { output: report(null), messages: `error: ${visibleLine(error.message)}\n`, exitCode: 2 };
  }
}

function seek(opened: OpenedFile, settings: FixSettings): Fixed {
  const line = createStatusLine();
  try {
    return fixLevel(opened, settings, (found, ticks) =>
      line.show(`fixing, ${(ticks / 1e6).toFixed(1)} million ticks: ${found} found so far; Ctrl-C ends`),
    );
  } finally {
    line.clear();
  }
}
