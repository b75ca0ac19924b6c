import type { Feature } from '../feature.ts';
import './conflicts.css';
import type { Editor } from '../../core/context/index.ts';
import { problemsInWords, type SaveState } from '../../core/files/index.ts';
import { laterCover } from '../../core/panel/index.ts';

/** What to do when the page and the file on disk disagree. */
export const conflicts: Feature = {
  name: 'conflicts',
  dialogs: laterCover(
    ({ overlay }) => overlay === 'conflict',
    () => import('./ConflictDialog.tsx').then(({ ConflictDialog }) => ConflictDialog),
  ),
  start: followDisagreement,
};

const TOPIC = 'disagreement';

/** Why the file on disk and the page differ; null if they agree or will agree without the user. */
function disagreementOf(id: string, state: SaveState): string | null {
  switch (state.kind) {
    case 'conflict':
      return 'This level was also changed on disk, and some of the changes conflict.';
    case 'deleted':
      return 'The file of this level was deleted on disk. The level on the screen is still complete.';
    case 'unreadable':
      return `The file on disk can't be read as a level. ${problemsInWords(`${id}.level.json`, state.problems)} The page shows the last valid state and continues by itself once the file is fixed.`;
    default:
      return null;
  }
}

/**
 * Shows a notice while the file on disk and the page differ, with a way to resolve it; the user may keep editing. A level that
 * has conflicts of a merge is opened with the question about them. @returns stops it
 */
function followDisagreement({ open, notices, session }: Editor): () => void {
  let stop = () => {};
  const follow = () => {
    stop();
    notices.clear(TOPIC);
    const level = open.getState();
    if (level === null) return;
    const { opened, document } = level;
    const { store } = opened.saver;
    let last: string | null = null;
    const look = () => {
      const text = disagreementOf(opened.id(), store.getState());
      if (text === last) return;
      last = text;
      if (text === null) {
        notices.clear(TOPIC);
        return;
      }
      const actions = [{ title: 'Review', run: () => session.setState({ overlay: 'conflict' }) }];
      notices.show('warning', text, { topic: TOPIC, actions });
    };
    look();
    stop = store.subscribe(look);
    // what a merge left undecided is asked once; afterwards the top bar and the problems offer it
    const isUndecided = (document.file().conflicts ?? []).length > 0;
    if (isUndecided && session.getState().overlay === null) session.setState({ overlay: 'conflict' });
  };
  follow();
  const stopOpen = open.subscribe(follow);
  return () => {
    stop();
    stopOpen();
  };
}
