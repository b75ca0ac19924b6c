export { declare } from './tune.ts';
