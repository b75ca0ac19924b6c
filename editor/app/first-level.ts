import type { Editor } from '../context/index.ts';
import { openFirst } from '../panels/levels/index.ts';

const KEY = 'gravity-quest-last-level';

/**
 * Opens the level that was last open in this tab, or else the first valid one, and remembers each level opened from then on.
 */
export async function openFirstLevel(editor: Editor): Promise<void> {
  const { workspace } = editor;
  await workspace.start();
  let last: string | null = null;
  try {
    last = window.sessionStorage.getItem(KEY);
  } catch {
    // The browser stores nothing: open the first level.
  }
  workspace.store.subscribe(({ opened }) => {
    if (opened === null) return;
    try {
      window.sessionStorage.setItem(KEY, opened.id());
    } catch {
      // the browser stores nothing
    }
  });
  await openFirst(editor, last);
}
