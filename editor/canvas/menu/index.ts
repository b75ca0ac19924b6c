export { CanvasMenu } from './CanvasMenu.tsx';
export { menuCommands, placeMeant } from './menu-commands.ts';
export { menuEntries } from './menu-entries.ts';
