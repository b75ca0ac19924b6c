export { App } from './App.tsx';
export { createEditor, tellKept } from './create-editor.ts';
export { openFirstLevel } from './first-level.ts';
