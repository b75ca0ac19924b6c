export { type Command, type Commands, createCommands, type Destination, findDestinations, needsOf } from './commands.ts';
export { followGamepads, listenToPads } from './gamepads.ts';
export { isModKey, keyLabel, keyLabels, listenToKeys } from './keyboard.ts';
