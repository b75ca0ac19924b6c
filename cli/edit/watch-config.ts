import { type FSWatcher, watch } from 'node:fs';
import { CONFIG_NAME, configFolders } from '../config-file.ts';
import type { KnownLevels } from './known-levels.ts';

/** ms from a change until the configuration is read: who writes it may not be done */
const PATIENCE = 60;

/**
 * Looks at the rules of the configuration whenever it may have changed: it may come and go in any folder in which it is looked for. What is not
 * seen this way is seen at the next load of the list.
 * @param folder from where it is looked for, upwards
 * @returns how to end it
 */
export function watchConfig(folder: string, known: Pick<KnownLevels, 'refreshRules'>): () => void {
  let timer: NodeJS.Timeout | null = null;
  const look = (): void => {
    timer = null;
    known.refreshRules();
  };
  const watchers = configFolders(folder).flatMap((at): FSWatcher[] => {
    try {
      const watcher = watch(at, { persistent: false }, (_, name) => {
        if (name === null || name === CONFIG_NAME) timer ??= setTimeout(look, PATIENCE);
      });
      // a folder that is gone, or may not be watched, has nothing to tell
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
