export { tuneLevel as default } from './tune-level.ts';
