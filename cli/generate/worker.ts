export { makeLevel as default } from './make-level.ts';
