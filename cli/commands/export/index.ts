import { extname } from 'node:path';
import process from 'node:process';
import { type Command, Option } from 'commander';
import { plural } from '../../../check/words/index.ts';
import { type ExportReport, MAX_FILE_SIZE, type OwnRules, readLevel } from '../../../schema/index.ts';
import type { CommandHelp, CommandResult } from '../../command.ts';
import { addConfigOptions, type ConfigOptions, readConfiguration } from '../../config/index.ts';
import { findConfigured } from '../../find/index.ts';
import {
  differing,
  expectOutput,
  type FileStatus,
  levelsRead,
  planFile,
  readBytes,
  statOrError,
  writeAll,
  writeWhole,
} from '../../io/index.ts';
import { formatOption } from '../../options/index.ts';
import { showFileProblems, showProblems } from '../../report-parts/index.ts';
import { colorsFor, Failure, namedPath, visibleLine } from '../../terminal/index.ts';
import { type Made, type OriginalOptions, type ReadFile, type Refused, toOriginal, toTiled } from './made.ts';

interface ExportOptions extends OriginalOptions, ConfigOptions {
  readonly to: 'gravityquest' | 'tiled';
  readonly out?: string;
  readonly force?: true;
  readonly format: 'pretty' | 'json';
}

export const help: CommandHelp = {
  description: "Turn levels back into the original game's level objects, or into Tiled maps.",
  more: `
gravityquest refuses what the original game does not have (kinds of objects, own rules, a level without recoil), each with its
place: without it the level plays differently. Names, descriptions, runs and ids are lost, with a warning. A Tiled map keeps
everything. gq import reads both back. Writes either every file or none.

Exit code: 0; 1 when a level is invalid or can't be said in the format; 2 when a file could not be read or written.

Examples:
  $ gq export levels --to gravityquest -o Levels.js
  $ gq export levels/01-first-pull.level.json --to tiled -o first.tmj
  $ gq export levels --to tiled --out maps`,
};

export function declare(command: Command, finish: (result: CommandResult) => void): void {
  addConfigOptions(command)
    .argument('<path...>', 'level files, directories, or quoted patterns with * ** ?')
    .addOption(
      new Option('--to <format>', 'gravityquest: one file with all levels; tiled: a map for each level')
        .choices(['gravityquest', 'tiled'])
        .makeOptionMandatory(),
    )
    .option('-o, --output <file>', 'the file to write (default: standard output); its ending chooses .json or .js, .tmj or .tmx')
    .option('--out <dir>', 'tiled: directory for the maps, each named after its level file; it is created when missing')
    .option('--module', "gravityquest: write a CommonJS module, as the original's; also chosen by -o FILE.js or FILE.cjs")
    .option('--by-number', 'gravityquest: level-07 becomes entry 7, counted from 0, with empty placeholders before it')
    .option('--drop', 'gravityquest: leave out what the original game does not have, with a warning')
    .option('--force', 'overwrite an existing file that differs')
    .addOption(formatOption('pretty', 'json'))
    .action(async (paths: string[], options: ExportOptions) => finish(await exportLevels(paths, options)));
}

/** Refuses options that say nothing together. */
function checkOptions({ to, output, out, module, byNumber, drop, format }: ExportOptions): void {
  const only = (option: string, format: string): Failure =>
    new Failure(`${option}: expected --to ${format}, found --to ${to}; leave out ${option.split(' ')[0]}`);
  if (to === 'tiled') {
    if (module) throw only('--module', 'gravityquest');
    if (byNumber) throw only('--by-number', 'gravityquest');
    if (drop) throw only('--drop', 'gravityquest');
    if (out !== undefined && output !== undefined) throw new Failure('-o and --out: expected one of the two, found both');
  } else if (out !== undefined) {
    throw only(`--out ${namedPath(out)}`, 'tiled');
  }
  if (format === 'json' && out === undefined && (output === undefined || output === '-')) {
    throw new Failure('--format json reports what was written: expected -o FILE beside it, found none');
  }
}

const ENDINGS = { gravityquest: ['.json', '.js', '.cjs'], tiled: ['.tmj', '.tmx', '.json', '.xml'] } as const;

function checkEnding({ to, output, module }: ExportOptions): void {
  if (output === undefined || output === '-') return;
  const ending = extname(output).toLowerCase();
  const known: readonly string[] = ENDINGS[to];
  if (!known.includes(ending))
    throw new Failure(`-o ${namedPath(output)}: expected a name that ends in ${known.join(', ')}, or - for standard output`);
  if (module && ending === '.json')
    throw new Failure(`--module -o ${namedPath(output)}: expected a name that ends in .js or .cjs for a module`);
}

function readAll(files: readonly string[], rules: OwnRules): { readonly levels: ReadFile[]; readonly invalid: Refused[] } {
  const levels: ReadFile[] = [];
  const invalid: Refused[] = [];
  for (const file of files) {
    const read = readLevel(readBytes(file), { rules });
    if (read.ok) levels.push({ file, level: read.level, source: read.document });
    else invalid.push({ file, problems: read.problems, text: read.text });
  }
  return { levels, invalid };
}

const shown = (invalid: readonly Refused[]): string =>
  invalid
    .map(({ file, problems, text }) => showFileProblems(file, showProblems(problems, text), colorsFor(process.stderr)))
    .join('');

async function exportLevels(paths: readonly string[], options: ExportOptions): Promise<CommandResult> {
  checkOptions(options);
  checkEnding(options);
  const configuration = await readConfiguration(options);
  const { files, unreadable } = await findConfigured(paths, configuration);
  if (unreadable.length > 0) {
    const list = unreadable.map(({ path, reason }) => `  ${path}: ${reason}\n`).join('');
    throw new Failure(`nothing was written, because directories can't be read:\n${list.trimEnd()}`);
  }
  const { levels, invalid } = readAll(files, configuration.rules);
  if (invalid.length > 0) return { messages: shown(invalid), exitCode: 1 };
  const made = options.to === 'tiled' ? toTiled(levels, options) : toOriginal(levels, options);
  if ('refused' in made) {
    const count = made.refused.reduce((sum, { problems }) => sum + problems.length, 0);
    const thing = count === 1 ? 'it' : 'them';
    const message = `nothing was written: the original game does not have what these levels have; --drop leaves ${thing} out\n`;
    return { messages: shown(made.refused) + message, exitCode: 1 };
  }
  const inputs = { ...levelsRead(files, 'read'), 'the configuration': configuration.file };
  for (const { file } of made.files) if (file !== '-') expectOutput(`-o ${file}`, file, inputs);
  return write(made, options);
}

/** Whether a path leads to something that is written to but has no content to compare with, such as a pipe. */
function isDevice(path: string): boolean {
  const stats = statOrError(path);
  return !(stats instanceof Error) && !stats.isFile() && !stats.isDirectory();
}

async function write({ files, warnings }: Made, options: ExportOptions): Promise<CommandResult> {
  const messages = warningsInWords(warnings);
  const [first] = files;
  if (files.length === 1 && first.file === '-') return { output: first.text, messages, exitCode: 0 };
  if (files.length === 1 && isDevice(first.file)) {
    await writeWhole(first.file, first.text);
    return { messages, exitCode: 0 };
  }
  // a map or a file of the original is larger than the levels in it
  const limit = 64 * MAX_FILE_SIZE;
  const planned = files.map(({ file, levels, text }) => ({ levels, ...planFile(file, text, 'gq export', limit) }));
  const others = differing(planned);
  if (others.length > 0 && options.force !== true) {
    const names = others.map(({ file }) => `  ${file}\n`).join('');
    const which = planned.length === 1 ? 'this file exists and differs' : 'these files exist and differ';
    throw new Failure(`nothing was written, because ${which}:\n${names}give another name, or --force to overwrite`);
  }
  await writeAll(planned, (folder) => (options.out === undefined ? namedPath(folder) : `--out ${namedPath(options.out)}`));
  const done = planned.map(({ file, levels, status }): ExportedFile => ({ file, levels, status }));
  const report = { files: done, warnings };
  if (options.format === 'json') return { output: exportJson(report), exitCode: 0 };
  return { output: exportPretty(report), messages, exitCode: 0 };
}

interface ExportedFile {
  readonly file: string;
  /** The level files that are in it. */
  readonly levels: readonly string[];
  readonly status: FileStatus;
}

interface Exported {
  readonly files: readonly ExportedFile[];
  readonly warnings: Made['warnings'];
}

/** Files that a warning names before it only counts them. */
const NAMED = 2;

/** Warnings for people: one for all files that it concerns. */
function warningsInWords(warnings: Made['warnings']): string {
  const files = new Map<string, string[]>();
  for (const { file, message } of warnings) files.set(message, [...(files.get(message) ?? []), visibleLine(file)]);
  return [...files]
    .map(([message, names]) => {
      const more = names.length > NAMED + 1 ? ` and ${names.length - NAMED} more` : '';
      const shown = more === '' ? names : names.slice(0, NAMED);
      return `warning: ${shown.join(', ')}${more}: ${visibleLine(message)}\n`;
    })
    .join('');
}

/** The results of `export` as JSON. */
function exportJson({ files, warnings }: Exported): string {
  const rows = files.map(({ file, levels, status }) => ({ file, levels: [...levels], status }));
  const report: ExportReport = { version: 1, files: rows, warnings: [...warnings] };
  return `${JSON.stringify(report)}\n`;
}

/** The results of `export` for people. */
function exportPretty({ files }: Exported): string {
  const lines = files.map(({ file, status, levels }) => `${status} ${visibleLine(file)}: ${plural(levels.length, 'level')}`);
  return `${lines.join('\n')}\n`;
}
