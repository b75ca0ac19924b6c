import process from 'node:process';
import type { Command } from 'commander';
import { plural } from '../../check/words/index.ts';
import { type FmtReport, formatLevel, formatPack, type Problem, readPack, withIds } from '../../schema/index.ts';
import { readContent } from '../../schema/level/index.ts';
import type { CommandHelp, CommandResult } from '../command.ts';
import { addConfigOptions, type ConfigOptions, readConfiguration } from '../config/index.ts';
import { type FoundFiles, findConfigured, PATHS, pathsOr } from '../find/index.ts';
import { isPackFile, once, packFormat, readBytes, readStdin, stdinName, whyNotWritable, writeWhole } from '../io/index.ts';
import { formatOption } from '../options/index.ts';
import { problemJson, type ShownProblem, showFileProblems, showProblems } from '../report-parts/index.ts';
import { type Annotation, type Places, pathInWorkspace, placesOf, workflowCommands } from '../reporters/index.ts';
import { type Colors, colorsFor, Failure, hearSignals, namedPath, shellPath, visible, visibleLine } from '../terminal/index.ts';

interface FmtOptions extends ConfigOptions {
  readonly stdinPath?: string;
  readonly check?: true;
  readonly format: 'pretty' | 'json' | 'github';
}

export const help: CommandHelp = {
  description:
    'Format level files and the pack.json of directories, and give an id to every object that has none. The content stays the same; an invalid file is left alone.',
  more: `
With the path -, one level is read from standard input, and its formatted text goes to standard output; with --check, nothing does.

Exit code: 0; 1 when a file is invalid or, with --check, would change; 2 when a file could not be read or written.

Examples:
  $ gq fmt
  $ gq fmt --check levels      for CI
  $ gq fmt --check --format github   annotations for a pull request
  $ gq fmt my.level.json
  $ gq fmt - < my.level.json`,
};

export function declare(command: Command, finish: (result: CommandResult) => void): void {
  addConfigOptions(command)
    .argument('[path...]', PATHS)
    .option('--check', 'only report which files would change')
    .option('--stdin-path <file>', 'with the path -: the name in messages of the level that is read from standard input')
    .addOption(formatOption('pretty', 'json', 'github'))
    .action(async (paths: string[], options: FmtOptions) => finish(await fmt(paths, options)));
}

/** What is found where only pack files are named. */
const NOTHING: FoundFiles = { files: [], packs: [], unreadable: [] };

async function fmt(paths: readonly string[], options: FmtOptions): Promise<CommandResult> {
  const stdin = stdinName(paths, options.stdinPath);
  if (stdin !== null) return fmtStdin(stdin, options);
  const configuration = await readConfiguration(options);
  const named = paths.filter(isPackFile);
  const rest = paths.filter((path) => !isPackFile(path));
  const found = named.length > 0 && rest.length === 0 ? NOTHING : await findConfigured(rest, configuration);
  const files = once([...found.files, ...found.packs.map(({ file }) => file), ...named]);
  const { unreadable } = found;
  const done: FormattedFile[] = [];
  const failures = unreadable.map(({ path, reason }) => `error: ${visibleLine(path)}: the directory can't be read: ${reason}\n`);
  for (const file of files) {
    await hearSignals();
    try {
      done.push(await formatFile(file, options.check === true));
    } catch (error) {
      if (!(error instanceof Failure)) throw error;
      failures.push(`error: ${visible(error.message)}\n`);
      done.push({ file, status: 'failed', problems: [] });
    }
  }
  const output = report(done, pathsOr(paths, configuration), options.format);
  const clean = done.every(({ status }) => status === 'unchanged' || status === 'formatted');
  // if a folder could not be read and no file was found, there is nothing to count
  return {
    output: done.length === 0 && options.format !== 'json' ? '' : output,
    messages: failures.join(''),
    exitCode: failures.length > 0 ? 2 : clean ? 0 : 1,
  };
}

function report(files: readonly FormattedFile[], paths: readonly string[], format: FmtOptions['format']): string {
  if (format === 'json') return fmtJson(files);
  if (format === 'github') return fmtGithub(files, placesOf(process.cwd(), process.env));
  return fmtPretty(files, paths, colorsFor(process.stdout));
}

/** The text of a level, or of the order of a pack, in its canonical layout; or what is wrong with it. */
type Canonical =
  | { readonly ok: true; readonly text: string }
  | { readonly ok: false; readonly problems: readonly Problem[]; readonly text: string };

function canonicalText(file: string, bytes: Uint8Array): Canonical {
  if (isPackFile(file)) {
    const read = readPack(bytes);
    return read.ok ? { ok: true, text: formatPack(read.pack) } : read;
  }
  const read = readContent(bytes);
  return read.ok ? { ok: true, text: formatLevel(withIds(read.document.file)) } : read;
}

/** A level from standard input: its formatted text, or what is wrong with it. */
function fmtStdin(name: string, { check, format }: FmtOptions): CommandResult {
  if (format !== 'pretty')
    throw new Failure(`--format ${format}: standard output gets the formatted text of standard input: leave it out`);
  const bytes = readStdin('fmt');
  const read = canonicalText(name, bytes);
  if (!read.ok)
    return { messages: showFileProblems(name, showProblems(read.problems, read.text), colorsFor(process.stderr)), exitCode: 1 };
  const { text } = read;
  if (!check) return { output: text, exitCode: 0 };
  if (Buffer.from(text).equals(bytes)) return { exitCode: 0 };
  return { messages: `${visibleLine(name)}: would change\n`, exitCode: 1 };
}

async function formatFile(file: string, onlyCheck: boolean): Promise<FormattedFile> {
  // a pack with one level would no longer be one
  if (packFormat(file) !== null)
    throw new Failure(`${namedPath(file)}: it is a pack: expected level files; leave it out, or unpack it`);
  const bytes = readBytes(file);
  const read = canonicalText(file, bytes);
  if (!read.ok) return { file, status: 'invalid', problems: showProblems(read.problems, read.text) };
  const { text } = read;
  if (Buffer.from(text).equals(bytes)) return { file, status: 'unchanged', problems: [] };
  if (!onlyCheck) {
    const why = whyNotWritable(file);
    if (why !== null) throw new Failure(`${namedPath(file)}: can't be written: ${why}`);
    await writeWhole(file, text);
  }
  return { file, status: onlyCheck ? 'would change' : 'formatted', problems: [] };
}

interface FormattedFile {
  readonly file: string;
  /** `failed`: the file could not be read or written, and is unchanged. */
  readonly status: 'unchanged' | 'formatted' | 'would change' | 'invalid' | 'failed';
  readonly problems: readonly ShownProblem[];
}

/** The results of `fmt` as JSON. */
function fmtJson(files: readonly FormattedFile[]): string {
  const list = files.map(({ file, status, problems }) => ({ file, status, problems: problems.map(problemJson) }));
  return `${JSON.stringify({ version: 1, files: list } satisfies FmtReport)}\n`;
}

/** The results of `fmt` as workflow commands: what would change and what is invalid, in the files of a pull request. */
function fmtGithub(files: readonly FormattedFile[], places: Places): string {
  const annotations = files.flatMap(({ file, status, problems }): Annotation[] => {
    const path = pathInWorkspace(file, places);
    if (status === 'would change') {
      const message = `the layout is not the canonical one\nto format it: gq fmt ${shellPath(file)}`;
      return [{ severity: 'error', file: path, line: null, column: null, title: 'layout', message }];
    }
    return problems.map(({ severity, line, column, code, message, hint }) => {
      return { severity, file: path, line, column, title: code, message: hint === '' ? message : `${message}\n${hint}` };
    });
  });
  return `${workflowCommands(annotations)}${countsInWords(files)}`;
}

/** What `fmt` did to the files of these paths, for a person: the files that were not as they should be, and a count. */
function fmtPretty(files: readonly FormattedFile[], paths: readonly string[], colors: Colors): string {
  let text = '';
  for (const { file, status, problems } of files) {
    // the reason for a failure goes to stderr
    if (status === 'unchanged' || status === 'failed') continue;
    const paint = status === 'invalid' ? colors.red : colors.yellow;
    text += `${paint(status)} ${visibleLine(file)}\n${showFileProblems(file, problems, colors)}`;
  }
  const wouldChange = files.some(({ status }) => status === 'would change');
  const todo = wouldChange ? `to format what would change: gq fmt ${paths.map((path) => shellPath(path)).join(' ')}\n` : '';
  return `${text}${countsInWords(files)}${todo}`;
}

/** A line that says how many files there are of each status. */
function countsInWords(files: readonly FormattedFile[]): string {
  const counts = (['unchanged', 'formatted', 'would change', 'invalid', 'failed'] as const)
    .map((status) => [status, files.filter((file) => file.status === status).length] as const)
    .filter(([, count]) => count > 0)
    .map(([status, count]) => `${count} ${status}`);
  return `${plural(files.length, 'file')}: ${counts.join(', ')}\n`;
}
