import type { Editor } from '../context/index.ts';

const TOPIC = 'disagreement';

/** Says so when the disk and the page do not agree, with a way to settle it; the person may go on meanwhile. @returns stops it */
export function followDisagreement({ open, notices, session }: Editor): () => void {
  let stop = () => {};
  const follow = () => {
    stop();
    notices.settle(TOPIC);
    const saver = open.getState()?.opened.saver;
    if (saver === undefined) return;
    let last = 'saved';
    const look = () => {
      const { kind } = saver.store.getState();
      if (kind === last) return;
      last = kind;
      if (kind !== 'conflict' && kind !== 'displaced') {
        notices.settle(TOPIC);
        return;
      }
      const text =
        kind === 'conflict'
          ? 'This level was changed on the disk, too, and not all of it can be brought together by itself.'
          : 'The file of this level was deleted or damaged on the disk. What is on the screen is still here.';
      const actions = [{ title: 'Look at it', run: () => session.setState({ overlay: 'conflict' }) }];
      notices.show('warning', text, { topic: TOPIC, actions });
    };
    look();
    stop = saver.store.subscribe(look);
  };
  follow();
  const stopOpen = open.subscribe(follow);
  return () => {
    stop();
    stopOpen();
  };
}
