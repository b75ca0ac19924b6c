import { dirname, relative, resolve } from 'node:path';
import process from 'node:process';
import { type ConfigFile, type ReporterName, readConfig } from '../schema/index.ts';
import { showProblems } from './code-frames.ts';
import { type ConfigOptions, chosenConfig } from './config-file.ts';
import { type Configuration, noConfiguration, type ReporterChoice } from './configuration.ts';
import { FileFailure } from './file-failure.ts';
import { whyOutside } from './inside-repository.ts';
import { Failure, namedPath, readBytes } from './io/index.ts';
import type { ConfiguredTerms } from './terms.ts';

/**
 * Reads the configuration that the options choose.
 * @param folder the search for it starts here and goes upwards
 * @throws Failure if it can't be read or is invalid, with every problem and its place
 */
export function readConfiguration(options: ConfigOptions, folder: string = process.cwd()): Configuration {
  const file = chosenConfig(options, folder);
  if (file === null) return noConfiguration();
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

/** What a configuration says about terms. */
export const termsIn = ({ accuracy, maxTime, maxWork, rules }: ConfigFile): ConfiguredTerms => ({
  accuracy: accuracy ?? null,
  maxTime: maxTime ?? null,
  maxWork: maxWork ?? null,
  rules: rules ?? {},
});

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
