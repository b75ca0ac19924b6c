import { type FolderRules, type Problem, readConfig } from '../../schema/index.ts';
import { type ConfigOptions, chosenConfig } from '../config-file.ts';
import { Failure } from '../failure.ts';
import { readBytes } from '../read-bytes.ts';

/** Returns the rules that the configuration sets now. */
export type RulesOnDisk = () => FolderRules;

export const NO_CONFIG: FolderRules = { file: null, own: {}, problems: [] };

/**
 * Reads the rules from the configuration of a folder again at every call. While the rules in it are invalid, the last valid
 * ones apply.
 * @param folder the search for the configuration starts here and goes upwards
 * @param config a file to read instead, or false for none
 */
export function rulesOnDisk(folder: string, config?: ConfigOptions['config']): RulesOnDisk {
  let last = NO_CONFIG;
  return () => {
    const file = chosenConfig({ config }, folder);
    last = file === null ? NO_CONFIG : { file, ...readRules(file, last.own) };
    return last;
  };
}

function readRules(file: string, before: FolderRules['own']): Omit<FolderRules, 'file'> {
  try {
    const read = readConfig(readBytes(file));
    return read.ok ? { own: read.config.rules ?? {}, problems: [] } : { own: read.rules ?? before, problems: read.problems };
  } catch (error) {
    if (!(error instanceof Failure)) throw error;
    return { own: before, problems: [unreadable(error.message)] };
  }
}

const unreadable = (message: string): Problem => ({
  code: 'unreadable-file',
  severity: 'error',
  message,
  hint: 'Make the file readable.',
  pointer: '',
  line: null,
  column: null,
});
