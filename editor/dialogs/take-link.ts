import type { Editor } from '../context/index.ts';
import { addLevels } from '../panels/levels/index.ts';
import { levelOf, slugOf } from '../share/index.ts';

/** Adds the level that the page's address carries, if it carries one, and takes it out of the address: loading the page again adds no second one. */
async function takeLink(editor: Editor): Promise<void> {
  const linked = await levelOf(window.location.hash);
  if (linked === null) return;
  window.history.replaceState(null, '', `${window.location.pathname}${window.location.search}`);
  if (!linked.ok) {
    editor.notices.show('error', linked.message, { topic: 'link' });
    return;
  }
  const added = await addLevels(editor, '', [{ stem: slugOf(linked.file.name), file: linked.file }]);
  if (added.length > 0)
    editor.notices.show('info', `"${linked.file.name}" came with the link and is a level of yours now.`, { topic: 'link' });
}

/** Takes in links, once it is known which levels there are: the one the page was opened with, and those that are typed into its address. @returns stops it */
export function followLinks(editor: Editor): () => void {
  const { store } = editor.workspace;
  const take = () => void takeLink(editor);
  let stop = () => {};
  const start = () => {
    stop();
    take();
    window.addEventListener('hashchange', take);
    stop = () => window.removeEventListener('hashchange', take);
  };
  if (store.getState().list !== null) start();
  else {
    stop = store.subscribe(({ list }) => {
      if (list !== null) start();
    });
  }
  return () => stop();
}
