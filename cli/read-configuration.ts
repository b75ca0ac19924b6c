import { dirname, relative, resolve } from 'node:path';
import process from 'node:process';
import { type ConfigFile, type ReporterName, readConfig } from '../schema/index.ts';
import { showProblems } from './code-frames.ts';
import { colorsFor } from './colors.ts';
import { type ConfigOptions, chosenConfig } from './config-file.ts';
import { type Configuration, noConfiguration, type ReporterChoice } from './configuration.ts';
import { Failure } from './failure.ts';
import { readBytes } from './read-bytes.ts';
import { showFileProblems } from './report-parts/index.ts';
import type { ConfiguredTerms } from './terms.ts';

/**
 * Reads the configuration that the options choose.
 * @param folder the search for it starts here and goes upwards
 * @throws Failure if it can't be read or is invalid, with every problem and its place
 */
export function readConfiguration(options: ConfigOptions, folder: string = process.cwd()): Configuration {
  const file = chosenConfig(options, folder);
  if (file === null) return noConfiguration();
  const read = readConfig(readBytes(file));
  if (read.ok) return configurationOf(file, read.config);
  const problems = showFileProblems(file, showProblems(read.problems, read.text), colorsFor(process.stderr));
  throw new Failure(`nothing was done: the configuration is not valid:\n${problems.trimEnd()}`);
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
