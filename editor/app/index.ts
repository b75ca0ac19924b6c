export { App } from './App.tsx';
export { createEditor, openFirstLevel } from './create-editor.ts';
