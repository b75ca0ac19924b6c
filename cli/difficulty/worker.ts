export { measureLevel as default } from './measure-level.ts';
