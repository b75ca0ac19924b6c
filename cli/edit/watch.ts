import { basename } from 'node:path';
import { watch } from 'chokidar';
import { systemReason } from '../failure.ts';
import type { KnownLevels } from './known-levels.ts';

/** ms from the first change until the folder is looked at: a checkout touches many files, and one file more than once */
const PATIENCE = 60;

/**
 * Looks at a folder whenever something in it has changed. What is not seen this way is seen at the next save or load of the list.
 * @returns once changes are seen: how to end it
 */
export function watchFolder(root: string, known: KnownLevels): Promise<() => Promise<void>> {
  let isWaiting = false;
  let timer: NodeJS.Timeout | undefined;
  const look = (): void => {
    isWaiting = false;
    known.refresh();
  };
  return new Promise((resolve) => {
    const watcher = watch(root, {
      ignoreInitial: true,
      followSymlinks: false,
      ignored: (path, stats) => path !== root && isOfNoInterest(basename(path), stats?.isFile() === true),
    });
    const end = (): Promise<void> => {
      clearTimeout(timer);
      return watcher.close();
    };
    watcher.on('all', () => {
      if (!isWaiting) timer = setTimeout(look, PATIENCE);
      isWaiting = true;
    });
    watcher.on('error', (error) => {
      known.addTrouble(`changes by other programs may be seen late: the folder can't be watched: ${systemReason(error)}`);
      resolve(end);
    });
    watcher.on('ready', () => resolve(end));
  });
}

const isOfNoInterest = (name: string, isFile: boolean): boolean =>
  name.startsWith('.') || name === 'node_modules' || (isFile && !name.endsWith('.level.json'));
