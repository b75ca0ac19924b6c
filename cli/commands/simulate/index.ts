export { declare } from '../simulate.ts';
