import type { Editor } from '../context/index.ts';
import { levelOf } from '../share/index.ts';

/** Takes the level that the page's address carries out of it, and asks the person: loading the page again asks no second time. */
async function takeLink({ notices, incoming }: Editor): Promise<void> {
  const { hash } = window.location;
  const linked = await levelOf(hash);
  if (linked === null) return;
  if (window.location.hash === hash) {
    // as a whole address: a path with two slashes at its front alone would name another host
    const bare = new URL(window.location.href);
    bare.hash = '';
    window.history.replaceState(window.history.state, '', bare.href.replace(/#$/, ''));
  }
  if (linked.ok) incoming.setState(linked.file, true);
  else notices.show('error', linked.message, { topic: 'link' });
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
