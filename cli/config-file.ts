import { existsSync } from 'node:fs';
import { dirname, join, relative, resolve } from 'node:path';
import process from 'node:process';
import type { Command } from 'commander';

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
