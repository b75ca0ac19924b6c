import { isAccuracyName } from '../../engine/index.ts';
import { type ConfigFile, type FolderTerms, type Problem, readConfig } from '../../schema/index.ts';
import { type ConfigOptions, chosenConfig } from '../config/index.ts';
import { readBytes } from '../io/index.ts';
import { termsFrom } from '../options/index.ts';
import { Failure } from '../terminal/index.ts';

/** Returns the terms that the configuration sets now. */
export type TermsOnDisk = () => FolderTerms;

/** The terms that a file sets, as the page gets them. */
function folderTerms(file: string | null, { accuracy, maxTime, maxWork, rules = {} }: ConfigFile): FolderTerms {
  const configured = { accuracy: accuracy ?? null, maxTime: maxTime ?? null, maxWork: maxWork ?? null, rules };
  const terms = termsFrom({}, configured);
  const { name } = terms.accuracy;
  if (!isAccuracyName(name)) throw new Error(`a configuration names its accuracy: ${name}`);
  return { ...terms, file, accuracy: name, problems: [] };
}

/** The terms of a folder without a configuration. */
export const NO_CONFIG: FolderTerms = folderTerms(null, {});

/**
 * Reads the terms from the configuration of a folder again at every call. While it is invalid, the last valid terms apply.
 * @param folder the search for the configuration starts here and goes upwards
 * @param config a file to read instead, or false for none
 */
export function termsOnDisk(folder: string, config?: ConfigOptions['config']): TermsOnDisk {
  let last = NO_CONFIG;
  return () => {
    const file = chosenConfig({ config }, folder);
    last = file === null ? NO_CONFIG : readTerms(file, last);
    return last;
  };
}

function readTerms(file: string, before: FolderTerms): FolderTerms {
  try {
    const read = readConfig(readBytes(file));
    // what is wrong elsewhere does not concern the rules
    if (!read.ok) return { ...before, file, rules: read.rules ?? before.rules, problems: read.problems };
    return folderTerms(file, read.config);
  } catch (error) {
    if (!(error instanceof Failure)) throw error;
    return { ...before, file, problems: [unreadable(error.message)] };
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
