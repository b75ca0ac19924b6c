export { changedFiles } from './changed-files.ts';
