import type { LevelEntry } from '../../../schema/index.ts';
import type { Workspace } from './workspace.ts';

/** The list of levels once it is complete: a long one comes in parts. */
export function allLevels({ store }: Pick<Workspace, 'store'>): Promise<readonly LevelEntry[]> {
  return new Promise((resolve) => {
    let stop = () => {};
    const look = () => {
      const { list, error } = store.getState();
      if (error === null && list !== null && list.unread > 0) return false;
      stop();
      resolve(list?.levels ?? []);
      return true;
    };
    if (!look()) stop = store.subscribe(look);
  });
}
