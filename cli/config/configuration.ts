import { existsSync } from 'node:fs';
import { dirname, join, relative, resolve } from 'node:path';
import process from 'node:process';
import type { Command } from 'commander';
import type { AccuracyName } from '../../engine/index.ts';
import type { ConfigFile, OwnRules, ReporterName, SeverityMap } from '../../schema/index.ts';

export const CONFIG_NAME = 'gq.config.json';

/** The folders to search for the configuration of a folder, the nearest first. */
export function configFolders(folder: string): string[] {
  const folders: string[] = [];
  for (let at = resolve(folder); ; at = dirname(at)) {
    folders.push(at);
    if (existsSync(join(at, '.git')) || dirname(at) === at) return folders;
  }
}

/**
 * The configuration that applies in a folder: the nearest `gq.config.json` on the way up to the root of the repository, the
 * first folder with a `.git`; without a repository, to the root of the file system.
 * @returns its path relative to the working directory; null if there is none
 */
export function findConfig(folder: string = process.cwd()): string | null {
  const path = configFolders(folder)
    .map((at) => join(at, CONFIG_NAME))
    .find((one) => existsSync(one));
  return path === undefined ? null : relative('', path);
}

/** The values of the options that `addConfigOptions` declares. */
export interface ConfigOptions {
  /** The file that `--config` names; false with `--no-config`. */
  readonly config?: string | boolean;
}

/** Declares `--config` and `--no-config`. */
export const addConfigOptions = (command: Command): Command =>
  command
    .option('--config <file>', 'configuration to use (default: the nearest gq.config.json up to the root of the repository)')
    .option('--no-config', 'use no configuration');

/**
 * The file of the configuration that the options choose, as the working directory sees it; null if there is none.
 * @param folder the search starts here and goes upwards
 */
export function chosenConfig({ config }: ConfigOptions, folder: string = process.cwd()): string | null {
  if (config === false) return null;
  return typeof config === 'string' ? config : findConfig(folder);
}

/** A report, and where it goes. */
export interface ReporterChoice {
  readonly name: ReporterName;
  /** The file to write, as the working directory sees it; null: stdout. */
  readonly file: string | null;
}

/** What `gq.config.json` sets. Its paths are turned into those that the working directory sees; null: not set. */
export interface Configuration {
  /** The file, as the working directory sees it; null without a configuration. */
  readonly file: string | null;
  /** Its directory, absolute; the working directory without a configuration. Patterns of `ignore` are relative to it. */
  readonly directory: string;
  readonly levels: readonly string[] | null;
  /** As written in the file. */
  readonly ignore: readonly string[];
  readonly accuracy: AccuracyName | null;
  /** s */
  readonly maxTime: number | null;
  /** Pieces of motion. */
  readonly maxWork: number | null;
  readonly requireSlack: number | null;
  readonly severity: SeverityMap;
  readonly maxWarnings: number | null;
  readonly reporters: readonly ReporterChoice[] | null;
  readonly lock: string | null;
  /** true or false: whether to keep results; a text: the directory for them. */
  readonly cache: boolean | string | null;
  readonly rules: OwnRules;
}

/** What holds without a configuration. */
export const noConfiguration = (): Configuration => ({
  file: null,
  directory: resolve(''),
  levels: null,
  ignore: [],
  accuracy: null,
  maxTime: null,
  maxWork: null,
  requireSlack: null,
  severity: {},
  maxWarnings: null,
  reporters: null,
  lock: null,
  cache: null,
  rules: {},
});

/** What a configuration says about terms. */
export type ConfiguredTerms = Pick<Configuration, 'accuracy' | 'maxTime' | 'maxWork' | 'rules'>;

/** What a whole configuration says about terms, and nothing else of it. */
export const termsSaid = ({ accuracy, maxTime, maxWork, rules }: ConfiguredTerms): ConfiguredTerms => ({
  accuracy,
  maxTime,
  maxWork,
  rules,
});

/** What the file of a configuration says about terms. */
export const termsIn = ({ accuracy, maxTime, maxWork, rules }: ConfigFile): ConfiguredTerms => ({
  accuracy: accuracy ?? null,
  maxTime: maxTime ?? null,
  maxWork: maxWork ?? null,
  rules: rules ?? {},
});
