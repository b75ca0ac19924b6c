import './core/ui/theme.css';
import './core/ui/ui.css';
import { StrictMode } from 'react';
import { createRoot } from 'react-dom/client';
import { App, createEditor, openFirstLevel } from './app/index.ts';
import { loadParts } from './core/panel/index.ts';
import { FEATURES } from './features/index.ts';
import './core/ui/touch.css';
import './core/ui/contrast.css';

/** Not awaited by this module: what is loaded later would wait for it. */
async function open(): Promise<void> {
  const arrived = FEATURES.flatMap(({ arrive }) => arrive?.(window) ?? []);
  const editor = await createEditor();
  createRoot(document.getElementById('root') as HTMLElement).render(
    <StrictMode>
      <App editor={editor} />
    </StrictMode>,
  );
  await openFirstLevel(editor);
  for (const follow of arrived) follow(editor);
  // once the level is drawn
  requestAnimationFrame(() => requestAnimationFrame(() => void loadParts()));
  // save the latest changes before the page may be closed
  document.addEventListener('visibilitychange', () => void editor.open.getState()?.opened.saver.flush());
}

void open();
