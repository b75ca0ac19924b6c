export { type Command, type Commands, createCommands, needsOf } from './commands.ts';
export { keyLabel } from './key-label.ts';
export { listenToKeys } from './keyboard.ts';
