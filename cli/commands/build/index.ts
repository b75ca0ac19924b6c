export { declare } from './build.ts';
