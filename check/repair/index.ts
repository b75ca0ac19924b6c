export { repairedFile } from './repaired-file.ts';
