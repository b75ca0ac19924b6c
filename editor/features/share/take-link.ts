import { placeIn } from '../../../schema/index.ts';
import type { Editor } from '../../core/context/index.ts';
import { levelOf } from '../../core/exchange/index.ts';

/** Takes the level out of the page's address and asks the user whether to add it; a reload does not ask again. */
async function takeLink({ notices, incoming }: Editor): Promise<void> {
  const { hash } = window.location;
  if (placeIn(hash) !== null) return;
  const linked = await levelOf(hash);
  if (linked === null) return;
  // a play beside the level is taken by itself
  if (hash.startsWith(window.location.hash) && window.location.hash !== '') {
    // A full URL: a path that begins with two slashes would otherwise name another host.
    const bare = new URL(window.location.href);
    bare.hash = '';
    window.history.replaceState(window.history.state, '', bare.href.replace(/#$/, ''));
  }
  if (linked.ok) incoming.setState(linked.file, true);
  else notices.show('error', linked.message, { topic: 'link' });
}

/**
 * Handles links once the list of levels is known: the link that opened the page, and links typed into its address. @returns
 * stops it
 */
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
