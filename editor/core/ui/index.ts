export { Button, Dialog, Hint } from './controls.tsx';
export { focusHome, keepFocus } from './focus.ts';
export { NumberField } from './NumberField.tsx';
