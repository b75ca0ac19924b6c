export { App } from './App.tsx';
export { createEditor } from './create-editor.ts';
export { openFirstLevel } from './first-level.ts';
