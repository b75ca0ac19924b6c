import './ui/theme.css';
import './ui/ui.css';
import { StrictMode } from 'react';
import { createRoot } from 'react-dom/client';
import * as z from 'zod';
import { App, createEditor, openFirstLevel, tellKept } from './app/index.ts';
import './ui/touch.css';
import './ui/contrast.css';

// a strict content security policy allows no code made from text
z.config({ jitless: true });

const editor = await createEditor();
createRoot(document.getElementById('root') as HTMLElement).render(
  <StrictMode>
    <App editor={editor} />
  </StrictMode>,
);
await openFirstLevel(editor);
void tellKept(editor);
// what was done last is written before the page may go
document.addEventListener('visibilitychange', () => void editor.open.getState()?.opened.saver.flush());
