import { mkdirSync, rmdirSync, rmSync } from 'node:fs';
import { dirname, join, resolve } from 'node:path';
import process from 'node:process';
import { type Command, Option } from 'commander';
import { formatLevel, importOriginal, MAX_FILE_SIZE } from '../../../schema/index.ts';
import { showProblems } from '../../code-frames.ts';
import { colorsFor } from '../../colors.ts';
import type { CommandResult } from '../../command.ts';
import { Failure, systemReason } from '../../failure.ts';
import { formatOption } from '../../options.ts';
import { readBytes } from '../../read-bytes.ts';
import { readRegularFile } from '../../regular-file.ts';
import { showFileProblems } from '../../report-parts/index.ts';
import { schemaReference } from '../../schema-reference.ts';
import { namedPath } from '../../shown-path.ts';
import { allOrNone } from '../../signals.ts';
import { replaceRegular } from '../../write-file.ts';
import { type ImportedFile, importJson, importPretty } from './report.ts';

interface ImportOptions {
  readonly out: string;
  readonly recoil: 'on' | 'off';
  readonly force?: true;
  readonly format: 'pretty' | 'json';
}

interface Target extends ImportedFile {
  readonly content: Uint8Array;
  /** The current content of the file; null if there is none. */
  readonly before: Uint8Array | null;
}

export function declare(command: Command, finish: (result: CommandResult) => void): void {
  command
    .description("Turn the original game's levels (a JSON array of its level objects, or one object) into level files.")
    .argument('<file>', 'JSON file with the original levels')
    .requiredOption('--out <dir>', 'directory for the level files; it is created when missing')
    .addOption(
      new Option('--recoil <on|off>', 'whether the levels have recoil, as the original has').choices(['on', 'off']).default('on'),
    )
    .option('--force', 'overwrite existing level files that differ')
    .addOption(formatOption('pretty', 'json'))
    .addHelpText(
      'after',
      `
Writes either every level or none. Exit code: 0; 1 when the file does not have the original's format; 2 when it could not be
read or the levels could not be written.

Examples:
  $ gq import levels.json --out imported
  $ gq import levels.json --out imported --recoil off --force`,
    )
    .action(async (file: string, options: ImportOptions) => finish(await importFile(file, options)));
}

async function importFile(file: string, options: ImportOptions): Promise<CommandResult> {
  const imported = importOriginal(readBytes(file), { recoil: options.recoil === 'on' });
  if (!imported.ok) {
    const problems = showProblems(imported.problems, imported.text);
    return { messages: showFileProblems(file, problems, colorsFor(process.stderr)), exitCode: 1 };
  }
  const $schema = schemaReference(options.out) ?? undefined;
  const targets = imported.levels.map(({ slug, file: level }): Target => {
    const path = join(options.out, `${slug}.level.json`);
    const content = Buffer.from(formatLevel({ $schema, ...level }));
    const before = contentOf(path);
    const status = before === null ? 'written' : content.equals(before) ? 'unchanged' : 'overwritten';
    return { file: path, level: level.name, content, before, status };
  });
  const differing = targets.filter((target) => target.status === 'overwritten');
  if (differing.length > 0 && options.force !== true) {
    const names = differing.map((target) => `  ${target.file}\n`).join('');
    throw new Failure(
      `nothing was written, because these files exist and differ:\n${names}give another --out, or --force to overwrite them`,
    );
  }
  await writeAll(options.out, targets);
  const result = { files: targets.map(({ file, level, status }) => ({ file, level, status })), notes: imported.notes };
  return { output: options.format === 'json' ? importJson(result) : importPretty(result), exitCode: 0 };
}

function contentOf(path: string): Uint8Array | null {
  try {
    const bytes = readRegularFile(path, MAX_FILE_SIZE);
    if (bytes.length > MAX_FILE_SIZE) throw new Error('it is larger than a level file may be: move it away');
    return bytes;
  } catch (error) {
    if (['ENOENT', 'ENOTDIR'].includes((error as NodeJS.ErrnoException).code ?? '')) return null;
    throw new Failure(`${path}: gq import writes a file here, but the existing one can't be read: ${systemReason(error)}`);
  }
}

/** Writes all files or none, even if a signal interrupts it. */
async function writeAll(directory: string, targets: readonly Target[]): Promise<void> {
  const done: Target[] = [];
  let made: string | undefined;
  await allOrNone(
    [
      () => {
        made = makeDirectory(directory);
      },
      ...targets
        .filter(({ status }) => status !== 'unchanged')
        .map((target) => () => {
          replaceRegular(target.file, target.content);
          done.push(target);
        }),
    ],
    () => {
      for (const { file, before } of done.reverse()) {
        if (before === null) rmSync(file, { force: true });
        else replaceRegular(file, before);
      }
      if (made !== undefined) removeDirectories(directory, made);
    },
  );
}

/** @returns the outermost directory that was created, if any */
function makeDirectory(directory: string): string | undefined {
  try {
    return mkdirSync(directory, { recursive: true });
  } catch (error) {
    throw new Failure(
      `--out ${namedPath(directory)}: the directory can't be created: ${systemReason(error)}; expected a directory that can be written`,
    );
  }
}

/** Removes empty directories, the innermost first. */
function removeDirectories(innermost: string, outermost: string): void {
  const last = resolve(outermost);
  for (let at = resolve(innermost); at.length >= last.length; at = dirname(at)) rmdirSync(at);
}
