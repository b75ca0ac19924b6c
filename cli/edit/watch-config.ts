import { type FSWatcher, watch } from 'node:fs';
import { basename, dirname } from 'node:path';
import { CONFIG_NAME, type ConfigOptions, configFolders } from '../config-file.ts';
import type { KnownLevels } from './known-levels.ts';

/** ms from a change until the configuration is read: the program that writes it may not have finished */
const PATIENCE = 60;

/**
 * Reads the terms of the configuration again when it may have changed: it may appear or vanish in any folder of the search. A
 * change that goes unnoticed shows at the next load of the list.
 * @param folder the search for the configuration starts here and goes upwards
 * @param config a file to watch instead, or false for none
 * @returns a function that stops it
 */
export function watchConfig(
  folder: string,
  known: Pick<KnownLevels, 'refreshTerms'>,
  config?: ConfigOptions['config'],
): () => void {
  if (config === false) return () => {};
  const isNamed = typeof config === 'string';
  const watched = isNamed ? basename(config) : CONFIG_NAME;
  let timer: NodeJS.Timeout | null = null;
  const look = (): void => {
    timer = null;
    known.refreshTerms();
  };
  const watchers = (isNamed ? [dirname(config)] : configFolders(folder)).flatMap((at): FSWatcher[] => {
    try {
      const watcher = watch(at, { persistent: false }, (_, name) => {
        if (name === null || name === watched) timer ??= setTimeout(look, PATIENCE);
      });
      // the folder is gone or can't be watched: its changes go unnoticed
      watcher.on('error', () => watcher.close());
      return [watcher];
    } catch {
      return [];
    }
  });
  return () => {
    if (timer !== null) clearTimeout(timer);
    for (const watcher of watchers) watcher.close();
  };
}
