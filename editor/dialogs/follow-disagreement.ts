import type { Editor } from '../context/index.ts';
import { problemsInWords, type SaveState } from '../files/index.ts';

const TOPIC = 'disagreement';

/** Why the disk and the page do not agree; null where they do, or will by themselves. */
function disagreementOf(id: string, state: SaveState): string | null {
  switch (state.kind) {
    case 'conflict':
      return 'This level was changed on the disk, too, and not all of it can be brought together by itself.';
    case 'deleted':
      return 'The file of this level was deleted on the disk. What is on the screen is still here.';
    case 'unreadable':
      return `The file on the disk can't be read as a level. ${problemsInWords(`${id}.level.json`, state.problems)} What is on the screen is the last good state; it goes on by itself once the file is mended.`;
    default:
      return null;
  }
}

/** Says so when the disk and the page do not agree, with a way to settle it; the person may go on meanwhile. @returns stops it */
export function followDisagreement({ open, notices, session }: Editor): () => void {
  let stop = () => {};
  const follow = () => {
    stop();
    notices.settle(TOPIC);
    const opened = open.getState()?.opened;
    if (opened === undefined) return;
    const { store } = opened.saver;
    let last: string | null = null;
    const look = () => {
      const text = disagreementOf(opened.id(), store.getState());
      if (text === last) return;
      last = text;
      if (text === null) {
        notices.settle(TOPIC);
        return;
      }
      const actions = [{ title: 'Look at it', run: () => session.setState({ overlay: 'conflict' }) }];
      notices.show('warning', text, { topic: TOPIC, actions });
    };
    look();
    stop = store.subscribe(look);
  };
  follow();
  const stopOpen = open.subscribe(follow);
  return () => {
    stop();
    stopOpen();
  };
}
