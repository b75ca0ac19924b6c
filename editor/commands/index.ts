export { type Command, type Commands, createCommands, needsOf } from './commands.ts';
export { keyLabel, keyLabels } from './key-label.ts';
export { listenToKeys } from './keyboard.ts';
