import { basename, join } from 'node:path';
import process from 'node:process';
import { type Command, Option } from 'commander';
import { plural } from '../../check/words/index.ts';
import {
  formatLevel,
  type ImportReading,
  type ImportReport,
  importOriginal,
  importTiled,
  isTiledMap,
  MAX_FILE_SIZE,
} from '../../schema/index.ts';
import type { CommandHelp, CommandResult } from '../command.ts';
import { differing, Outputs, type PlannedFile, planFile, readBytes, writeAll } from '../io/index.ts';
import { schemaReference } from '../levels/index.ts';
import { formatOption } from '../options/index.ts';
import { showFileProblems, showProblems } from '../report-parts/index.ts';
import { colorsFor, Failure, namedPath, visibleLine } from '../terminal/index.ts';

interface ImportOptions {
  readonly out: string;
  readonly recoil?: 'on' | 'off';
  readonly force?: true;
  readonly format: 'pretty' | 'json';
}

type Target = ImportedFile & PlannedFile;

export const help: CommandHelp = {
  description:
    "Turn the original game's levels (a JSON array of its level objects, or one object) or a Tiled map into level files.",
  more: `
Writes either every level or none. Exit code: 0; 1 when the file has neither the original's format nor Tiled's; 2 when it could
not be read or the levels could not be written.

Examples:
  $ gq import levels.json --out imported
  $ gq import levels.json --out imported --recoil off --force
  $ gq import drawn.tmj --out levels       writes levels/drawn.level.json`,
};

export function declare(command: Command, finish: (result: CommandResult) => void): void {
  command
    .argument('<file>', 'JSON file with the original levels, or a module that exports them; or a Tiled map (.tmj, .tmx)')
    .requiredOption('--out <dir>', 'directory for the level files; it is created when missing')
    .addOption(
      new Option('--recoil <on|off>', 'whether levels of the original have recoil, as they have there (default: "on")').choices([
        'on',
        'off',
      ]),
    )
    .option('--force', 'overwrite existing level files that differ')
    .addOption(formatOption('pretty', 'json'))
    .action(async (file: string, options: ImportOptions) => finish(await importFile(file, options)));
}

/** `maps/First swing.tmj` becomes `First swing`. */
const stemOf = (file: string): string => basename(file.replaceAll('\\', '/')).replace(/\.(tmj|tmx|json|xml)$/i, '');

function read(file: string, { recoil }: ImportOptions): ImportReading {
  const bytes = readBytes(file);
  if (!isTiledMap(bytes)) return importOriginal(bytes, { recoil: recoil !== 'off' });
  if (recoil !== undefined)
    throw new Failure(
      `--recoil ${recoil}: expected levels of the original game, found a Tiled map; the property "recoil" of the map says it`,
    );
  return importTiled(bytes, { slug: stemOf(file) });
}

async function importFile(file: string, options: ImportOptions): Promise<CommandResult> {
  const imported = read(file, options);
  if (!imported.ok) {
    const problems = showProblems(imported.problems, imported.text);
    return { messages: showFileProblems(file, problems, colorsFor(process.stderr)), exitCode: 1 };
  }
  if (options.out === '') throw new Failure('--out "": expected a folder, found an empty name; . is the working directory');
  const $schema = schemaReference(options.out) ?? undefined;
  const targets = imported.levels.map(({ slug, file: level }): Target => {
    const path = join(options.out, `${slug}.level.json`);
    return { level: level.name, ...planFile(path, formatLevel({ $schema, ...level }), 'gq import', MAX_FILE_SIZE) };
  });
  const outputs = new Outputs({ [namedPath(file)]: file });
  const onItself = targets.find((target) => outputs.wouldReplaceInput(target.file) !== null);
  if (onItself !== undefined)
    throw new Failure(`nothing was written: ${namedPath(onItself.file)} is what is imported; give another --out`);
  const others = differing(targets);
  if (others.length > 0 && options.force !== true) {
    const names = others.map((target) => `  ${target.file}\n`).join('');
    throw new Failure(
      `nothing was written, because these files exist and differ:\n${names}give another --out, or --force to overwrite them`,
    );
  }
  await writeAll(targets, () => `--out ${namedPath(options.out)}`);
  const result = { files: targets.map(({ file, level, status }) => ({ file, level, status })), notes: imported.notes };
  return { output: options.format === 'json' ? importJson(result) : importPretty(result), exitCode: 0 };
}

interface ImportedFile {
  readonly file: string;
  /** The level's name. */
  readonly level: string;
  readonly status: 'written' | 'overwritten' | 'unchanged';
}

interface Imported {
  readonly files: readonly ImportedFile[];
  /** What was skipped or ignored, one sentence for each. */
  readonly notes: readonly string[];
}

/** The results of `import` as JSON. */
const importJson = ({ files, notes }: Imported): string =>
  `${JSON.stringify({ version: 1, files: [...files], notes: [...notes] } satisfies ImportReport)}\n`;

/** The results of `import` for people. */
function importPretty({ files, notes }: Imported): string {
  const lines = files.map(({ file, status }) => `${status} ${visibleLine(file)}`);
  lines.push(...notes.map((note) => `note: ${visibleLine(note)}`));
  lines.push(
    `${plural(files.length, 'level')} imported; gq solve LEVEL --write adds a run to one, and gq check shows which can be completed`,
  );
  return `${lines.join('\n')}\n`;
}
