export { Button } from './Button.tsx';
export { Dialog } from './Dialog.tsx';
export { focusHome, keepFocus } from './focus.ts';
export { Hint } from './Hint.tsx';
export { NumberField } from './NumberField.tsx';
export { FINGER, useCoarse } from './use-coarse.ts';
