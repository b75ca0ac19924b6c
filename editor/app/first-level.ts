import type { Editor } from '../core/context/index.ts';
import { openFirst } from '../core/levels/index.ts';
import { FEATURES } from '../features/index.ts';

const KEY = 'gravity-quest-last-level';

/**
 * Opens the place that the page's address names, or else the level that was last open in this tab, or else the first valid one.
 * Remembers each level opened from then on, and follows links to other places.
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
  for (const { openNamed } of FEATURES) if (await openNamed?.(editor)) return;
  await openFirst(editor, last);
}
