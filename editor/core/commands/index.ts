export { type Command, type Commands, createCommands, needsOf } from './commands.ts';
export { type Destination, findDestinations } from './destinations.ts';
export { followGamepads } from './gamepads.ts';
export { keyLabel, keyLabels } from './key-label.ts';
export { isModKey, listenToKeys } from './keyboard.ts';
export { listenToPads } from './listen-to-pads.ts';
