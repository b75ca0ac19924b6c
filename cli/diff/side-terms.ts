import { posix, relative } from 'node:path';
import process from 'node:process';
import { readConfig } from '../../schema/index.ts';
import { CONFIG_NAME, findConfig } from '../config-file.ts';
import { noConfiguration } from '../configuration.ts';
import { readBytes } from '../io/index.ts';
import { termsIn } from '../read-configuration.ts';
import { type ConfiguredTerms, termsSaid } from '../terms.ts';
import { readObjects } from './git.ts';

/** What the working directory's configuration says about terms, as a commit or the index has it. An invalid one is ignored with a message. */
export function termsInTree(root: string, tree: string, label: string, messages: string[]): ConfiguredTerms {
  const here = relative(root, process.cwd()).replaceAll('\\', '/');
  const folders: string[] = [];
  for (let at = here; at !== '' && at !== '.'; at = posix.dirname(at)) folders.push(`${at}/`);
  const paths = [...folders, ''].map((folder) => folder + CONFIG_NAME);
  const found = readObjects(paths.map((path) => `${tree}:${path}`));
  const index = found.findIndex((bytes) => bytes !== null);
  const bytes = found[index];
  return bytes == null ? termsSaid(noConfiguration()) : termsOfBytes(bytes, `${paths[index]} in ${label}`, messages);
}

/** What the configuration that is nearest to a folder says about terms. */
export function termsOfFolder(folder: string, messages: string[]): ConfiguredTerms {
  const file = findConfig(folder);
  return file === null ? termsSaid(noConfiguration()) : termsOfBytes(readBytes(file), file, messages);
}

function termsOfBytes(bytes: Uint8Array, name: string, messages: string[]): ConfiguredTerms {
  const read = readConfig(bytes);
  if (read.ok) return termsIn(read.config);
  const [{ message, line }] = read.problems;
  messages.push(`warning: ${name} is not valid, and is left out: ${line === null ? '' : `line ${line}: `}${message}`);
  return termsSaid(noConfiguration());
}
