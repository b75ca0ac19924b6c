export { CanvasMenu } from './CanvasMenu.tsx';
export { menuCommands } from './menu-commands.ts';
export { menuEntries } from './menu-entries.ts';
