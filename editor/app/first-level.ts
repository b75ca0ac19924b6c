import type { Editor } from '../context/index.ts';

const KEY = 'gravity-quest-last-level';

/** Opens the level that was open last in this tab, else the first valid one; remembers what is opened from now on. */
export async function openFirstLevel({ workspace }: Editor): Promise<void> {
  await workspace.start();
  const { list } = workspace.store.getState();
  let last: string | null = null;
  try {
    last = window.sessionStorage.getItem(KEY);
  } catch {
    // a browser that keeps nothing: the first one then
  }
  const levels = list?.levels ?? [];
  const first = levels.find(({ id }) => id === last) ?? levels.find(({ status }) => status === 'valid');
  workspace.store.subscribe(({ opened }) => {
    if (opened === null) return;
    try {
      window.sessionStorage.setItem(KEY, opened.id());
    } catch {
      // as above
    }
  });
  if (first !== undefined) await workspace.open(first.id);
}
