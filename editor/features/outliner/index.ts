export { Outliner } from './Outliner.tsx';
export { objectRows } from './object-rows.ts';
