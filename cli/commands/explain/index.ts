export { declare } from './explain.ts';
