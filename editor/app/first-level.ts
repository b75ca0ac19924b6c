import type { Editor } from '../context/index.ts';
import { openFirst } from '../panels/levels/index.ts';

const KEY = 'gravity-quest-last-level';

/** Opens the level that was open last in this tab, else the first valid one; remembers what is opened from now on. */
export async function openFirstLevel(editor: Editor): Promise<void> {
  const { workspace } = editor;
  await workspace.start();
  let last: string | null = null;
  try {
    last = window.sessionStorage.getItem(KEY);
  } catch {
    // a browser that keeps nothing: the first one then
  }
  workspace.store.subscribe(({ opened }) => {
    if (opened === null) return;
    try {
      window.sessionStorage.setItem(KEY, opened.id());
    } catch {
      // as above
    }
  });
  await openFirst(editor, last);
}
