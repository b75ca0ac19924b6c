import './core/ui/theme.css';
import './core/ui/ui.css';
import { StrictMode } from 'react';
import { createRoot } from 'react-dom/client';
import * as z from 'zod';
import { App, createEditor, openFirstLevel, tellKept } from './app/index.ts';
import { followPlayLinks, takeLinkedPlay } from './features/plays/index.ts';
import './core/ui/touch.css';
import './core/ui/contrast.css';

// the strict content security policy forbids code made from text
z.config({ jitless: true });

const linkedPlay = takeLinkedPlay(window);
const editor = await createEditor();
createRoot(document.getElementById('root') as HTMLElement).render(
  <StrictMode>
    <App editor={editor} />
  </StrictMode>,
);
await openFirstLevel(editor);
followPlayLinks(editor, linkedPlay);
tellKept(editor, window.location.host);
// save the latest changes before the page may be closed
document.addEventListener('visibilitychange', () => void editor.open.getState()?.opened.saver.flush());
