export { centreOf, type SelectionBox, selectionBox } from './box.ts';
export { cursorOf, drawnBox, type Grip, handleAt, handlesOf, type ScaleHandle } from './handles.ts';
export { scalingOf } from './scaling.ts';
export { transformActions } from './transform-actions.ts';
export { transformCommands } from './transform-commands.ts';
