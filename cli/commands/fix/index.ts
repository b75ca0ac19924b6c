import process from 'node:process';
import type { Command } from 'commander';
import {
  accuracyInWords,
  effortInWords,
  outcomeInWords,
  plural,
  proposalInWords,
  proposalRunInWords,
  SIZE_MEANS,
  termsReport,
} from '../../../check/words/index.ts';
import { type FixReport, type Level, listOf } from '../../../schema/index.ts';
import { changeEdits, type ObjectRef } from '../../../solver/index.ts';
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
import { type Colors, colorsFor, createStatusLine, Failure, uncut, visible, visibleLine } from '../../terminal/index.ts';
import { type Fixed, type FixedFile, type FixSettings, fixLevel } from './fixed.ts';

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

/** What `gq fix` prints for people. */
function fixPretty(level: Level, { terms, seed }: FixSettings, fixed: Fixed, colors: Colors): string {
  const { verdict, completing, impossible, fixes, effort, seconds, isFinished } = fixed;
  const head = `${colors.bold(visibleLine(level.name))}, ${accuracyInWords(terms)}: ${verdict}`;
  if (completing !== null) {
    return `${head}\nnothing to fix: run ${JSON.stringify(visibleLine(level.runs[completing].name))} completes the level\n`;
  }
  const why = impossible === null ? '' : `${visible(impossible.reason)}\n`;
  const spent = `effort  ${effortInWords(effort)}, ${seconds.toFixed(1)} s, seed ${seed}\n`;
  if (fixes.length === 0) {
    const more = isFinished ? 'no single change of those that were tried is enough' : 'a larger --budget or --effort tries more';
    return `${head}\n${why}${colors.yellow('no fix found')}: ${more}\n\n${spent}`;
  }
  const parts = fixes.map(({ proposal, run }, i) => {
    const size = proposal.change === null ? 'the level stays as it is' : `${proposal.size.toFixed(1)} px`;
    return (
      `${colors.bold(`${i + 1}`)}  ${colors.green(visibleLine(proposalInWords(level, proposal)))}\n` +
      `   ${size}; ${visibleLine(proposalRunInWords(level, proposal))}: ${outcomeInWords(run, level.range)}\n`
    );
  });
  const found = `${plural(fixes.length, 'proposal')}, each the smallest that was found of its kind. ${SIZE_MEANS}`;
  return `${head}\n${why}\n${parts.join('')}\n${found}\n${spent}`;
}

/** What `gq fix` prints as JSON. @param written the number of the proposal that is in the file now */
function fixReport(level: Level, { terms, seed }: FixSettings, fixed: Fixed, written: number | null): FixReport {
  const { verdict, completing, impossible, fixes, effort, seconds, isFinished } = fixed;
  return {
    version: 1,
    level: level.name,
    accuracy: terms.accuracy.name,
    terms: termsReport({ terms, level }),
    verdict,
    completedBy: completing === null ? null : level.runs[completing].name,
    impossible: impossible === null ? null : { code: impossible.code, reason: impossible.reason },
    proposals: fixes.map((fix) => proposalJson(level, fix)),
    effort: { ...effort, seconds, seed },
    isFinished,
    written,
  };
}

function proposalJson(level: Level, { proposal, run }: FixedFile): FixReport['proposals'][number] {
  const { change, size, origin } = proposal;
  const object = change === null || change.what === 'range' ? null : change.what === 'velocity' ? START : change.object;
  return {
    kind: change?.what ?? 'run',
    object: object === null ? null : { ...object, id: idOf(level, object) },
    size,
    words: proposalInWords(level, proposal),
    edits: (change === null ? [] : changeEdits(change)).map(({ path, value }) => {
      const from = path.reduce<unknown>((at, key) => (at as Readonly<Record<string | number, unknown>>)[key], level);
      return { pointer: `/${path.join('/')}`, from: typeof from === 'number' ? from : null, to: value };
    }),
    run: {
      origin: origin.from,
      name: origin.from === 'search' ? null : level.runs[origin.index].name,
      shifted: origin.from === 'adjusted' ? origin.ticks : null,
      holds: proposal.run.holds.map(([press, release]) => [press, release]),
      tick: run.tick,
      time: run.time,
      minerals: [...proposal.run.minerals],
      hash: run.hash,
    },
  };
}

const START: ObjectRef = { kind: 'astronaut', index: 0 };

function idOf(level: Level, { kind, index }: ObjectRef): string | null {
  if (kind === 'astronaut' || kind === 'blackHole') return null;
  return level[listOf(kind)][index].id;
}
