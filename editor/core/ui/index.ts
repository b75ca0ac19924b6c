export { Button, Dialog, Hint } from './Button.tsx';
export { focusHome, keepFocus } from './focus.ts';
export { NumberField } from './NumberField.tsx';
