import type { Configuration } from './configuration.ts';
import { Failure } from './failure.ts';
import { type FoundFiles, findLevelFiles } from './files.ts';
import { ignoreOf } from './ignore.ts';

/** The help of an argument for paths. */
export const PATHS =
  'level files, directories, or quoted patterns with * ** ? (default: "levels" of gq.config.json, else levels)';

/**
 * The paths that a command works on: those that are given, else those of the configuration, else `levels`.
 */
export const pathsOr = (paths: readonly string[], { levels }: Pick<Configuration, 'levels'>): readonly string[] =>
  paths.length > 0 ? paths : (levels ?? ['levels']);

/**
 * Finds the level files that a command works on, without those that the configuration leaves out.
 * @throws Failure with every path that matches nothing, or only what is left out
 */
export async function findConfigured(paths: readonly string[], configuration: Configuration): Promise<FoundFiles> {
  const { file, levels } = configuration;
  try {
    return await findLevelFiles(pathsOr(paths, configuration), { file, ignores: await ignoreOf(configuration) });
  } catch (error) {
    if (!(error instanceof Failure) || paths.length > 0 || levels === null) throw error;
    throw new Failure(`${error.message}\nno path was given, so "levels" of ${file} counts`);
  }
}
