export { declare } from './check.ts';
