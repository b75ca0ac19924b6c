import { mkdirSync, readFileSync, rmdirSync, rmSync } from 'node:fs';
import { join } from 'node:path';
import process from 'node:process';
import { type Command, Option } from 'commander';
import { formatLevel, importOriginal } from '../../schema/index.ts';
import { showProblems } from '../code-frames.ts';
import { colorsFor } from '../colors.ts';
import type { CommandResult } from '../command.ts';
import { Failure, systemReason } from '../failure.ts';
import { formatOption } from '../options.ts';
import { readBytes } from '../read-bytes.ts';
import { type ImportedFile, importJson, importPretty } from '../reporters/import.ts';
import { showFileProblems } from '../reporters/problem.ts';
import { schemaReference } from '../schema-reference.ts';
import { namedPath } from '../shown-path.ts';
import { writeWhole } from '../write-file.ts';

interface ImportOptions {
  readonly out: string;
  readonly recoil: 'on' | 'off';
  readonly force?: true;
  readonly format: 'pretty' | 'json';
}

interface Target extends ImportedFile {
  readonly text: string;
}

export function declare(command: Command, finish: (result: CommandResult) => void): void {
  command
    .description("Turn the original game's levels (a JSON array of its level objects, or one object) into level files.")
    .argument('<file>', 'JSON of the original levels')
    .requiredOption('--out <dir>', 'directory for the level files; made when missing')
    .addOption(
      new Option('--recoil <on|off>', 'whether the levels have recoil, as the original has').choices(['on', 'off']).default('on'),
    )
    .option('--force', 'overwrite level files that are there and differ')
    .addOption(formatOption('pretty', 'json'))
    .addHelpText(
      'after',
      `
Either every level is written or none. Exit code: 0; 1 when the file is not what the original has; 2 when it could not be
read or the levels not be written.

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
    const text = formatLevel({ $schema, ...level });
    const before = contentOf(path);
    return {
      file: path,
      level: level.name,
      text,
      status: before === null ? 'written' : before === text ? 'unchanged' : 'overwritten',
    };
  });
  const differing = targets.filter((target) => target.status === 'overwritten');
  if (differing.length > 0 && options.force !== true) {
    const names = differing.map((target) => `  ${target.file}\n`).join('');
    throw new Failure(
      `nothing was written: these files are there and differ\n${names}give another --out, or --force to overwrite them`,
    );
  }
  await writeAll(options.out, targets);
  const result = { files: targets.map(({ file, level, status }) => ({ file, level, status })), notes: imported.notes };
  return { output: options.format === 'json' ? importJson(result) : importPretty(result), exitCode: 0 };
}

function contentOf(path: string): string | null {
  try {
    return readFileSync(path, 'utf8');
  } catch (error) {
    if (['ENOENT', 'ENOTDIR'].includes((error as NodeJS.ErrnoException).code ?? '')) return null;
    throw new Failure(`${path}: a file is to be written here, but what is there can't be read: ${systemReason(error)}`);
  }
}

/** Writes every file, or leaves the directory as it was but for files that `--force` overwrote. */
async function writeAll(directory: string, targets: readonly Target[]): Promise<void> {
  const made = makeDirectory(directory);
  const created: string[] = [];
  try {
    for (const { file, text, status } of targets) {
      if (status === 'unchanged') continue;
      writeWhole(file, text);
      if (status === 'written') created.push(file);
    }
  } catch (error) {
    for (const file of created) rmSync(file, { force: true });
    if (made) rmdirSync(directory);
    throw error;
  }
}

function makeDirectory(directory: string): boolean {
  try {
    return mkdirSync(directory, { recursive: true }) !== undefined;
  } catch (error) {
    throw new Failure(
      `--out ${namedPath(directory)}: the directory can't be made: ${systemReason(error)}; expected a directory that can be written`,
    );
  }
}
