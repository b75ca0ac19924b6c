export { declare } from './generate.ts';
