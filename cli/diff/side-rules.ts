import { posix, relative } from 'node:path';
import process from 'node:process';
import { type OwnRules, readConfig } from '../../schema/index.ts';
import { CONFIG_NAME, findConfig } from '../config-file.ts';
import { readBytes } from '../read-bytes.ts';
import { readObjects } from './git.ts';

/** The rules of the working directory's configuration as a commit or the index has it. An invalid one is ignored with a message. */
export function rulesInTree(root: string, tree: string, label: string, messages: string[]): OwnRules {
  const here = relative(root, process.cwd()).replaceAll('\\', '/');
  const folders: string[] = [];
  for (let at = here; at !== '' && at !== '.'; at = posix.dirname(at)) folders.push(`${at}/`);
  const paths = [...folders, ''].map((folder) => folder + CONFIG_NAME);
  const found = readObjects(paths.map((path) => `${tree}:${path}`));
  const index = found.findIndex((bytes) => bytes !== null);
  const bytes = found[index];
  return bytes == null ? {} : rulesOfBytes(bytes, `${paths[index]} in ${label}`, messages);
}

/** The rules of the configuration that is nearest to a folder. */
export function rulesOfFolder(folder: string, messages: string[]): OwnRules {
  const file = findConfig(folder);
  return file === null ? {} : rulesOfBytes(readBytes(file), file, messages);
}

function rulesOfBytes(bytes: Uint8Array, name: string, messages: string[]): OwnRules {
  const read = readConfig(bytes);
  if (read.ok) return read.config.rules ?? {};
  const [{ message, line }] = read.problems;
  messages.push(`warning: ${name} is not valid, and its rules are left out: ${line === null ? '' : `line ${line}: `}${message}`);
  return {};
}
