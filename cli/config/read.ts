import { dirname, isAbsolute, relative, resolve, sep } from 'node:path';
import process from 'node:process';
import { type ConfigFile, type ReporterName, readConfig } from '../../schema/index.ts';
import { readBytes, realTarget, repositoryOf } from '../io/index.ts';
import { FileFailure, showProblems } from '../report-parts/index.ts';
import { Failure, namedPath, systemReason } from '../terminal/index.ts';
import { type Configuration, type ReporterChoice, termsIn } from './configuration.ts';

/**
 * Reads the file of a configuration.
 * @throws Failure if it can't be read or is invalid, with every problem and its place
 */
export function readConfigurationFile(file: string): Configuration {
  const bytes = readBytes(file);
  const read = readConfig(bytes);
  if (read.ok) {
    expectInside(file, bytes, read.config);
    return configurationOf(file, read.config);
  }
  const problems = showProblems(read.problems, read.text);
  throw new FileFailure('nothing was done: the configuration is not valid', [{ file, problems }]);
}

/**
 * Paths of a configuration stay in its repository, whichever of them a command uses.
 * @throws Failure with the place of the first that does not
 */
function expectInside(file: string, bytes: Uint8Array, { levels, reporters, lock, cache }: ConfigFile): void {
  const paths: readonly (readonly [text: string, path: string, read: string | null])[] = [
    ...listOf(levels ?? []).map((path) => [path, path, process.cwd()] as const),
    ...(reporters ?? [])
      .filter((text) => text.includes('='))
      .map((text) => [text, text.slice(text.indexOf('=') + 1), null] as const),
    ...[lock, cache].filter((path) => typeof path === 'string').map((path) => [path, path, null] as const),
  ];
  for (const [text, path, read] of paths) {
    const why = whyOutside(dirname(resolve(file)), path, read);
    if (why === null) continue;
    throw new Failure(
      `nothing was done: ${namedPath(file)}${placeOf(bytes, text)}: ${JSON.stringify(text)} ${why}: expected a path inside of the repository of the configuration; an argument of the command line may name any path`,
    );
  }
}

/** `:3:14`, where a text stands in a file; '' if it is written in another way. */
function placeOf(bytes: Uint8Array, text: string): string {
  const before = Buffer.from(bytes).toString('utf8').split(JSON.stringify(text), 2);
  if (before.length < 2) return '';
  const lines = before[0].split('\n');
  return `:${lines.length}:${lines[lines.length - 1].length + 1}`;
}

const listOf = (one: string | readonly string[]): readonly string[] => (typeof one === 'string' ? [one] : one);

function configurationOf(file: string, config: ConfigFile): Configuration {
  const directory = dirname(resolve(file));
  const seen = (path: string): string => relative('', resolve(directory, path)) || '.';
  return {
    file,
    directory,
    levels: config.levels === undefined ? null : listOf(config.levels).map(seen),
    ignore: listOf(config.ignore ?? []),
    ...termsIn(config),
    requireSlack: config.requireSlack ?? null,
    severity: config.severity ?? {},
    maxWarnings: config.maxWarnings ?? null,
    reporters: config.reporters?.map((text) => reporterOf(text, seen)) ?? null,
    lock: config.lock === undefined ? null : seen(config.lock),
    cache: typeof config.cache === 'string' ? seen(config.cache) : (config.cache ?? null),
  };
}

function reporterOf(text: string, seen: (path: string) => string): ReporterChoice {
  const at = text.indexOf('=');
  const name = (at < 0 ? text : text.slice(0, at)) as ReporterName;
  return { name, file: at < 0 ? null : seen(text.slice(at + 1)) };
}

/** An absolute path of Windows: `C:\levels`, `\\server\levels`. Elsewhere it would be a strange name of a file. */
const OF_WINDOWS = /^(?:[A-Za-z]:|[\\/]{2})/;

/** The folder in which git keeps its own files, by any of its names on file systems that don't tell them apart. */
const OF_GIT = /^(?:\.git|git~\d+)[. ]*(?::.*)?$/i;

/** What a pattern of files begins with: the folders before its first wildcard. */
const fixedPart = (pattern: string): string => pattern.replace(/(?:^|[\\/])[^\\/]*[*?[{(!].*$/s, '');

/**
 * Why a path in a configuration must not be used: it may come from a stranger, and a command that runs in a clone must not touch
 * what is around it. Links count by where they lead.
 * @param folder the folder of the configuration, to which the path is relative
 * @param path a path, or a pattern of paths
 * @param read a folder besides, from which is only read: with `--config`, a configuration may be for levels beside it; null: none
 * @returns null if the path stays in the repository, outside of git's own files
 */
export function whyOutside(folder: string, path: string, read: string | null): string | null {
  if (OF_WINDOWS.test(path) && !isAbsolute(path)) return 'is an absolute path of Windows';
  try {
    const root = repositoryOf(realTarget(folder));
    const target = realTarget(resolve(folder, fixedPart(path)));
    const inside = [root, ...(read === null ? [] : [realTarget(read)])]
      .map((one) => relative(one, target))
      .find((way) => !isAbsolute(way) && way.split(sep)[0] !== '..');
    if (inside === undefined) return `leads to ${target}, outside of ${root}`;
    return inside.split(sep).some((part) => OF_GIT.test(part)) ? `leads to ${target}, among git's own files` : null;
  } catch (error) {
    return `leads to nowhere: ${systemReason(error)}`;
  }
}
