import { type SpawnSyncReturns, spawnSync } from 'node:child_process';
import { chmodSync, readFileSync } from 'node:fs';
import { join } from 'node:path';
import process from 'node:process';
import { fileURLToPath } from 'node:url';
import { MAIN, makeFiles } from '../cli/gq.ts';

const ROOT = fileURLToPath(new URL('../../', import.meta.url));

/** A file of the package. */
export const ofPackage = (name: string): string => readFileSync(join(ROOT, name), 'utf8');

/** A shell script that stands for the command that npm links. */
const shim = (...lines: string[]): string => `#!/bin/sh\n${lines.join('\n')}\n`;

const GQ = shim(`exec '${process.execPath}' '${MAIN}' "$@"`);

/** Writes its arguments, one a line, into a file beside itself, and then the reports that it was asked for. */
const RECORDER = shim(
  'for argument in "$@"; do echo "$argument"; done > "$0.arguments"',
  `for argument in "$@"; do case $argument in *=*.xml | *=*.sarif) echo report > "\${argument#*=}" ;; esac; done`,
  'exit 1',
);

export interface Project {
  readonly directory: string;
  remove(): void;
}

/**
 * A project in which gq is installed.
 * @param gq `real`: the built command; `recorder`: one that only writes down its arguments and ends with 1
 * @param at the folder in which node_modules is, with a slash at the end
 */
export function makeProject(files: Readonly<Record<string, string>>, gq: 'real' | 'recorder' | 'none', at = ''): Project {
  const bin = `${at}node_modules/.bin/gq`;
  const project = makeFiles({ ...files, ...(gq === 'none' ? {} : { [bin]: gq === 'real' ? GQ : RECORDER }) });
  if (gq !== 'none') chmodSync(join(project.directory, bin), 0o755);
  return project;
}

/** Runs a program in a project, with the environment of a person who has no settings. */
export function runIn(
  directory: string,
  program: string,
  args: readonly string[],
  env: Readonly<Record<string, string>> = {},
): SpawnSyncReturns<string> {
  const { FORCE_COLOR: _, GITHUB_WORKSPACE: __, GITHUB_STEP_SUMMARY: ___, ...rest } = process.env;
  const bin = join(directory, 'node_modules', '.bin');
  const quiet = { ...rest, NO_COLOR: '1', PATH: `${bin}:${process.env.PATH}`, npm_config_update_notifier: 'false' };
  return spawnSync(program, args, { cwd: directory, env: { ...quiet, ...env }, encoding: 'utf8', timeout: 120_000 });
}
