export { declare } from './diff.ts';
