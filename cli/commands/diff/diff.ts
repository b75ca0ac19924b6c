import { existsSync } from 'node:fs';
import { availableParallelism } from 'node:os';
import process from 'node:process';
import { type Command, Option } from 'commander';
import { plural } from '../../../check/words/index.ts';
import { levelInLines } from '../../../review/index.ts';
import { type DiffReport, readLevel } from '../../../schema/index.ts';
import { readContent } from '../../../schema/level/index.ts';
import type { CommandHelp, CommandResult } from '../../command.ts';
import { findConfig } from '../../config/index.ts';
import {
  chooseComparison,
  type Diff,
  type DiffedLevel,
  type DiffSettings,
  diffFiles,
  type JudgedVersion,
  type PlayedVersions,
  playVersions,
  termsOfSides,
} from '../../diff/index.ts';
import { expectOutput, readBytes, writeWhole } from '../../io/index.ts';
import { addTermsOptions, formatOption, jobsOption, type TermsOptions } from '../../options/index.ts';
import { problemJson } from '../../report-parts/index.ts';
import { colorsFor, Failure, PLAIN, visible, visibleLine } from '../../terminal/index.ts';
import { diffText } from './text.ts';

interface Options extends TermsOptions {
  readonly staged?: true;
  readonly exitCode?: true;
  readonly textconv?: string;
  readonly slack: boolean;
  readonly format: 'text' | 'json' | 'html' | 'svg';
  readonly output?: string;
  readonly theme: 'dark' | 'light';
  readonly jobs: number;
}

export const help: CommandHelp = {
  description:
    'Show what changed in levels: objects by id, runs by name, and what that does to verdict, time, slack and minerals.',
  more: `
Without REF the working tree, untracked level files included, is compared with HEAD; with one REF, with that; with two, or
REF..REF, the second is compared with the first. REF...REF compares the second with the commit where both parted.

Exit code: 0; with --exit-code 1 if a level file differs; 2 when the comparison could not be made.

Examples:
  $ gq diff                          what changed since the last commit
  $ gq diff main...feature levels    what a branch changes
  $ gq diff old.level.json new.level.json
  $ gq diff main --format html -o diff.html`,
};

export function declare(command: Command, finish: (result: CommandResult) => void): void {
  addTermsOptions(
    command
      .argument('[words...]', 'up to two revisions, then level files, folders or quoted patterns; or two files; or two folders')
      .usage('[options] [REF [REF]] [--] [PATH...]')
      .option('--staged', 'compare what is staged for the next commit, and not the working tree')
      .option('--exit-code', 'end with 1 if any level file differs')
      .option('--textconv <file>', 'print one level as lines of text, for the textconv of git diff, and compare nothing')
      .option('--no-slack', 'do not measure how far presses and releases can move, which takes most of the time'),
  )
    .addOption(formatOption('text', 'json', 'html', 'svg'))
    .option('-o, --output <file>', 'write to FILE and not to standard output')
    .addOption(new Option('--theme <theme>', 'colours of --format svg').choices(['dark', 'light']).default('dark'))
    .addOption(jobsOption(availableParallelism()))
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
  const { slack, jobs, textconv } = options;
  if (textconv !== undefined) {
    if (words.length > 0) throw new Failure(`--textconv takes one file and nothing else, found ${words.join(' ')}`);
    return { output: textOfLevel(readBytes(textconv)), exitCode: 0 };
  }
  if (options.output !== undefined)
    expectOutput(`-o ${options.output}`, options.output, {
      'a file that is compared': words.filter((word) => existsSync(word)),
      'the configuration': findConfig(),
    });
  const comparison = await chooseComparison({ ...divided(words, command), staged: options.staged === true });
  const settings = { terms: termsOfSides(comparison, options), slack };
  const result = await diffFiles(comparison, settings, jobs);
  const exitCode = options.exitCode && result.levels.length > 0 ? 1 : 0;
  const messages = comparison.messages.map((message) => `${visible(message)}\n`).join('');
  const output = await written(result, settings, options);
  if (options.output === undefined) return { output, messages, exitCode };
  await writeWhole(options.output, output);
  return { messages: `${messages}wrote ${visibleLine(options.output)}\n`, exitCode };
}

/** The diff in the format that is asked for. Pictures are loaded only where they are drawn. */
async function written(result: Diff, settings: DiffSettings, { format, output, theme }: Options): Promise<string> {
  if (format === 'json') return diffJson(result);
  if (format === 'text') return diffText(result, output === undefined ? colorsFor(process.stdout) : PLAIN);
  const play = (i: number): PlayedVersions => playVersions(result.pairs[i], result.levels[i], settings);
  if (format === 'html') return (await import('./page.ts')).diffPage(result, play);
  if (result.levels.length !== 1) {
    throw new Failure(
      `--format svg draws one level, and ${plural(result.levels.length, 'level')} changed: name the file of one, or use --format html`,
    );
  }
  const svg = (await import('./page.ts')).diffSvg(result.levels[0], play(0), { width: 1200, theme });
  if (svg !== null) return svg;
  throw new Failure('there is nothing to draw: neither version of the file is a valid level');
}

/** The diff as JSON. */
function diffJson({ comparison, rules, levels, same }: Diff): string {
  const report: DiffReport = {
    version: 1,
    before: comparison.before.label,
    after: comparison.after.label,
    rules: rules.map(({ rule, before = null, after = null }) => ({ rule, before, after })),
    levels: levels.map(levelJson),
    same,
  };
  return `${JSON.stringify(report)}\n`;
}

const levelJson = ({ status, before, after, changes, words, effects }: DiffedLevel): DiffReport['levels'][number] => ({
  file: (after ?? before)?.file ?? '',
  status,
  words: [...words],
  effects: [...effects],
  before: before === null ? null : versionJson(before),
  after: after === null ? null : versionJson(after),
  changes: changes === null ? null : (changes as DiffReport['levels'][number]['changes']),
});

function versionJson({
  file,
  name,
  terms,
  verdict,
  problems,
  standing,
}: JudgedVersion): NonNullable<DiffReport['levels'][number]['before']> {
  const run = standing?.run ?? null;
  return {
    file,
    name,
    terms,
    verdict,
    problems: problems.map(problemJson),
    mineralCount: standing?.mineralCount ?? null,
    run:
      run === null
        ? null
        : {
            name: run.name,
            holds: run.holds.map(([press, release]) => [press, release]),
            outcome: run.outcome,
            with: run.with,
            time: run.time,
            tick: run.tick,
            minerals: run.minerals,
            clearance: run.clearance,
            slack: run.slack === null ? null : run.slack.edges.map(([earlier, later]) => [earlier, later]),
            smallestWindow: run.slack?.smallestWindow ?? null,
          },
  };
}

/** A level as lines of text; a file that is not a valid level as it is, after the reason, so that `git diff` still shows it. */
function textOfLevel(bytes: Uint8Array): string {
  const read = readLevel(bytes);
  if (read.ok) return levelInLines(read.document.file);
  const [{ message, line, column }] = read.problems;
  const place = line === null ? '' : `${line}:${column ?? 1}: `;
  // with a mark before it, a level is still one to look at
  const marked = readContent(bytes);
  const content = marked.ok ? levelInLines(marked.document.file) : new TextDecoder().decode(bytes);
  return `not a valid level: ${place}${message}\n${content}`;
}
